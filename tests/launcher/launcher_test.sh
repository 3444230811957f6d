#!/usr/bin/env bash
# launcher_test.sh CHECKOUT COMPILER CASE: one test of the launcher.
#
# A copy of the launcher in a small tree of its own meets stand-ins for apt-get, dpkg-query, sudo, cmake and ctest,
# which write down how they were called. Scripts are compiled by the real compiler.
set -euo pipefail

checkout=$1
compiler=$2
case=$3

world=$(mktemp -d)
trap 'rm -rf "$world"' EXIT
root="$world/the checkout"
calls=$world/calls
mkdir -p "$root/src" "$root/examples" "$world/bin" "$world/study"
for folder in materials elements structures analyses; do mkdir "$root/$folder"; done
cp "$checkout/moat" "$root/"
cp -r "$checkout/cmake" "$root/"
echo '#pragma once' >"$root/src/moat.hpp"
touch "$root/CMakeLists.txt" "$root/CMakePresets.json" "$root/src/unused.hpp"
touch "$world/installed" "$calls"
script=$world/study/tower.cpp
# shellcheck disable=SC2016 # the stand-ins expand these themselves
{
  program() { cat >"$world/bin/$1" && chmod +x "$world/bin/$1"; }
  program dpkg-query <<<'#!/bin/bash
    for package in "$@"; do
      grep -qx -- "$package" "$WORLD/installed" || continue
      case $* in *Version*) echo "installed 1.0" ;; *) echo "installed $package" ;; esac
    done'
  program apt-get <<<'#!/bin/bash
    echo "apt-get $*" >>"$WORLD/calls"
    case $* in
      *--yes*assume-no*) echo "--yes wins over --assume-no" >&2; exit 1 ;;
      *assume-no*) echo "0 upgraded, 14 newly installed, 0 to remove."; echo "Need to get 0 B/531 MB of archives." ;;
      *install*) for word in "$@"; do echo "$word"; done >>"$WORLD/installed" ;;
    esac'
  program cmake <<<'#!/bin/bash
    echo "cmake $*" >>"$WORLD/calls"
    build=$ROOT/build/release
    mkdir -p "$build/src"
    case $* in
      *" -n") [[ -e $build/src/libmoat.so && ! -e $WORLD/work ]] && echo "ninja: no work to do." ;;
      *--build*)
        [[ ! -e $WORLD/build_fails ]] || { echo "the reason why"; exit 1; }
        mkdir "$WORLD/building" || { echo "two build at the same time"; exit 1; }
        sleep 0.2 # long enough for another one to come along
        date +%N >"$build/src/libmoat.so"; rm -f "$WORLD/work"
        rmdir "$WORLD/building" ;;
      *)
        touch "$build/build.ninja" "$build/script_link.txt"
        echo "CMAKE_HOME_DIRECTORY:INTERNAL=$ROOT" >"$build/CMakeCache.txt"
        [[ $* != *MOAT_BUILD_TESTS=ON* ]] || echo "MOAT_BUILD_TESTS:BOOL=ON" >>"$build/CMakeCache.txt"
        printf "%s\n" "$COMPILER" -isystem "$ROOT/src" >"$build/script_compile.txt" ;;
    esac'
  program ctest <<<'#!/bin/bash
    echo "ctest $* with records ${MOAT_RECORDS-none}" >>"$WORLD/calls"
    [[ ! -e $WORLD/ctest_fails ]] || exit 8
    [[ -e $WORLD/skips ]] || { echo "100% tests passed, 0 tests failed out of 1"; exit; }
    log=$ROOT/build/release/Testing/Temporary/LastTest.log; mkdir -p "${log%/*}"
    printf "%s\n" "1/1 Testing: motions.Reader.Real" "Output:" "[ RUN      ] Reader.Real" "reader_test.cpp:7: Skipped" \
      "Set MOAT_RECORDS to the" "folder of records." "" "[  SKIPPED ] Reader.Real (0 ms)" >"$log"
    printf "%s\n" "100% tests passed, 0 tests failed out of 1" "" "The following tests did not run:"
    printf "\t  1 - motions.Reader.Real (Skipped)\n"'
  program sudo_without_password <<<'#!/bin/bash
    [[ $1 != --non-interactive ]] || exit 0
    echo "sudo $*" >>"$WORLD/calls"; exec "$@"'
}

cat >"$script" <<'END'
#include <moat.hpp>
#include <cstdio>
#include "height of it.hpp"
int main(int count, char** words) {
  std::printf("%d m, called %s", height, words[0]);
  for (int i = 1; i < count; ++i) std::printf(" [%s]", words[i]);
  std::puts("");
  return count > 1 && words[1][0] == '7' ? 7 : 0;
}
END
echo 'const int height = 30;' >"$world/study/height of it.hpp"

# launch ARGUMENT...: leaves the exit code in $code and the output in $out and $err.
launch() {
  code=0
  : >"$calls"
  env -u MOAT_RECORDS ${records:+MOAT_RECORDS="$records"} PATH="$world/bin:$PATH" WORLD="$world" ROOT="$root" \
    COMPILER="$compiler" ${as_user[@]+"${as_user[@]}"} "$root/moat" "$@" >"$world/out" 2>"$world/err" </dev/null || code=$?
  out=$(<"$world/out")
  err=$(<"$world/err")
}
records=
as_user=()

fail() {
  printf 'FAILED: %s\n--- exit code %s\n--- output\n%s\n--- errors\n%s\n--- calls\n%s\n' \
    "$1" "$code" "$out" "$err" "$(<"$calls")"
  exit 1
}
code_is() { [[ $code == "$1" ]] || fail "the exit code should be $1"; }
out_is() { [[ $out == "$1" ]] || fail "the output should be: $1"; }
out_tells() { [[ $out == *"$1"* ]] || fail "the output should tell: $1"; }
err_tells() { [[ $err == *"$1"* ]] || fail "the errors should tell: $1"; }
is_quiet() { [[ -z $err ]] || fail "nothing should be told"; }
called() { grep -q -- "$1" "$calls" || fail "should have called: $1"; }
not_called() { ! grep -q -- "$1" "$calls" || fail "should not have called: $1"; }

# Nobody may read what root made in a temporary folder, unless told.
become_nobody() {
  ((EUID != 0)) || { as_user=(setpriv --reuid=65534 --regid=65534 --clear-groups) && chown -R 65534:65534 "$world"; }
}

case $case in
  first_run)
    launch run "$script" --gap 3 'two words'
    code_is 0
    out_is "30 m, called $script [--gap] [3] [two words]"
    called "apt-get .*install --yes --no-install-recommends .*libvtk9-dev"
    not_called libgtest-dev
    err_tells "14 packages, 0 B to download"
    for phase in lists install configure build compile; do err_tells "moat: $phase"; done
    launch run "$script" 7
    code_is 7
    ;;
  second_run_does_nothing)
    launch run "$script"
    launch run "$script" --help
    code_is 0
    is_quiet
    out_is "30 m, called $script [--help]"
    not_called .
    ;;
  notices_changed_library)
    launch run "$script"
    touch "$root/src/moat.hpp" "$world/work"
    launch run "$script"
    called "cmake --build"
    not_called "apt-get"
    not_called "cmake -S"
    err_tells compile
    launch run "$script"
    not_called .
    ;;
  notices_deleted_header)
    launch run "$script"
    rm "$root/src/unused.hpp"
    launch run "$script"
    called "cmake --build"
    ;;
  notices_changed_script)
    launch run "$script"
    sed -i 's/%d m/%d metres/' "$script"
    launch run "$script"
    out_is "30 metres, called $script"
    sed -i 's/%d metres/%d m/' "$script"
    launch run "$script"
    is_quiet
    out_is "30 m, called $script"
    ;;
  notices_changed_include)
    launch run "$script"
    echo 'const int height = 40;' >"$world/study/height of it.hpp"
    launch run "$script"
    out_is "40 m, called $script"
    ;;
  keeps_spaces_in_names)
    mv "$world/study" "$world/my \$study #1"
    mv "$world/my \$study #1/tower.cpp" "$world/my \$study #1/a tower.cpp"
    cd "$world/my \$study #1"
    launch run "a tower.cpp"
    out_is "30 m, called a tower.cpp"
    launch run "a tower.cpp"
    is_quiet
    ;;
  runs_at_the_same_time)
    (launch run "$script" && out_is "30 m, called $script") &
    first=$!
    world_of_second=$world/second
    mkdir "$world_of_second"
    env PATH="$world/bin:$PATH" WORLD="$world" ROOT="$root" COMPILER="$compiler" "$root/moat" run "$script" second \
      >"$world_of_second/out" 2>"$world_of_second/err"
    wait "$first"
    out=$(<"$world_of_second/out") err=$(<"$world_of_second/err") code=0
    out_is "30 m, called $script [second]"
    [[ $(find "$root/build/scripts" -type f | wc -l) == 2 ]] || fail "one program and its list of files should be left"
    ;;
  script_does_not_compile)
    launch run "$script"
    sed -i 's/height,/hight,/' "$script"
    launch run "$script"
    code_is 1
    err_tells "hight"
    err_tells "$root/build/logs/compile.log"
    [[ -z $(find "$root/build/scripts" -name 'compiling*') ]] || fail "nothing half-made should be left"
    ;;
  library_does_not_build)
    touch "$world/build_fails"
    launch run "$script"
    code_is 1
    err_tells "the reason why"
    err_tells "$root/build/logs/build.log"
    rm "$world/build_fails"
    launch run "$script"
    code_is 0
    ;;
  without_root)
    printf '%s\n' '#!/bin/bash' 'exit 1' >"$world/bin/sudo"
    chmod +x "$world/bin/sudo"
    echo "cmake" >"$world/installed"
    become_nobody
    launch run "$script"
    code_is 3
    err_tells "apt-get install --no-install-recommends g++ ninja-build"
    not_called .
    launch test
    code_is 3
    err_tells "libgtest-dev"
    ;;
  with_sudo)
    mv "$world/bin/sudo_without_password" "$world/bin/sudo"
    become_nobody
    export http_proxy=http://proxy.example:3128
    launch run "$script"
    code_is 0
    called "sudo env http_proxy=http://proxy.example:3128 .*apt-get .*install"
    ;;
  without_apt)
    # Only what the launcher itself needs is on the PATH.
    for tool in bash env basename cat cut dirname find flock grep mkdir readlink realpath sed sha256sum tail; do
      ln -s "$(command -v "$tool")" "$world/bin/$tool"
    done
    rm "$world"/bin/{apt-get,dpkg-query,cmake}
    PATH=$world/bin
    launch run "$script"
    PATH=/usr/bin:/bin
    code_is 3
    err_tells "This is not Debian"
    err_tells "libvtk9-dev"
    ;;
  wrong_usage)
    for arguments in "" "frobnicate" "run" "run --fast" "run $world/no.cpp" "run $root/CMakeLists.txt" "doctor now" \
      "new" "new $script" "new tower.txt" "bench" "bench tower"; do
      # shellcheck disable=SC2086 # several words on purpose
      launch $arguments
      code_is 2
      [[ -n $err && -z $out ]] || fail "a sentence on standard error is missing"
      not_called .
    done
    ;;
  explains_itself)
    for arguments in "--help" "run --help" "new --help" "test --help" "doctor --help" "bench --help" \
      "bench paper --help"; do
      # shellcheck disable=SC2086
      launch $arguments
      code_is 0
      is_quiet
      out_tells "./moat"
      not_called .
    done
    ;;
  every_example_of_the_help_runs)
    export HOME=$world/home
    mkdir -p "$HOME/records"
    mv "$world/study" "$HOME/study"
    ln -s "$root" "$HOME/moat"
    cp "$HOME/study/tower.cpp" "$root/examples/01_moat_wall.cpp"
    cp "$HOME/study/height of it.hpp" "$root/examples/"
    for benchmark in paper accuracy performance; do
      mkdir -p "$root/build/release/benchmarks/$benchmark"
      # shellcheck disable=SC2016 # the stand-in expands this itself
      printf '#!/bin/bash\n[[ -z $1 || $1 == --* ]]\n' >"$root/build/release/benchmarks/$benchmark/$benchmark"
      chmod +x "$root/build/release/benchmarks/$benchmark/$benchmark"
    done
    grep -hv '^#' "$root"/cmake/packages/*.txt >"$world/installed"
    count=0
    for arguments in "--help" "run --help" "new --help" "test --help" "doctor --help" "bench --help"; do
      # shellcheck disable=SC2086
      launch $arguments
      code_is 0
      # Two blanks end a command; words in capitals and brackets stand for something else.
      while IFS= read -r example; do
        [[ $example != *"moat new "* ]] || rm "$HOME/study/tower.cpp"
        code=0
        (cd "$root" && env -u MOAT_RECORDS PATH="$world/bin:$PATH" WORLD="$world" ROOT="$root" COMPILER="$compiler" \
          bash -c "$example") >"$world/out" 2>"$world/err" </dev/null || code=$?
        out=$(<"$world/out") err=$(<"$world/err")
        [[ $code == 0 ]] || fail "this should run: $example"
        count=$((count + 1))
      done < <(sed -n 's/^  \([^ ].*moat [a-z].*\)/\1/p' <<<"$out" | sed 's/  .*//' | grep -v '[[]\|SCRIPT\.cpp')
    done
    ((count >= 15)) || fail "only $count examples were found"
    ;;
  moved_checkout)
    launch run "$script"
    mv "$root" "$world/elsewhere"
    root=$world/elsewhere
    launch run "$script"
    code_is 0
    called "cmake .*--fresh"
    ;;
  lists_skipped_tests)
    touch "$world/skips"
    launch test -R Reader
    code_is 0
    called "apt-get .*install .*libgtest-dev"
    not_called chromium
    called "cmake -S .*MOAT_BUILD_TESTS=ON"
    called "ctest .*-R Reader"
    out_tells "  motions.Reader.Real: Set MOAT_RECORDS to the folder of records."
    out_tells "MOAT_RECORDS is not set"
    launch run "$script"
    not_called "cmake -S"
    ;;
  all_fails_on_skipped_tests)
    records=$world/study
    launch test --all
    code_is 0
    called "apt-get .*install .*chromium"
    touch "$world/skips"
    launch test --all
    code_is 1
    out_tells "motions.Reader.Real"
    not_called "ctest .*--all"
    ;;
  all_demands_records)
    launch test --all
    code_is 2
    err_tells MOAT_RECORDS
    not_called .
    ;;
  finds_records_from_anywhere)
    cd "$world"
    records=study
    launch test
    code_is 0
    called "with records $world/study"
    records=nowhere
    launch test
    code_is 2
    err_tells "MOAT_RECORDS is nowhere, which is not a folder"
    ;;
  passes_on_the_code_of_ctest)
    touch "$world/ctest_fails"
    launch test
    code_is 8
    ;;
  benchmark_is_built_and_run)
    mkdir -p "$root/build/release/benchmarks/paper"
    printf '%s\n' '#!/bin/bash' 'echo "paper $* with records ${MOAT_RECORDS-none}"; exit 5' \
      >"$root/build/release/benchmarks/paper/paper"
    chmod +x "$root/build/release/benchmarks/paper/paper"
    launch bench paper --out there
    code_is 5
    out_is "paper --out there with records none"
    called "cmake --build .*moat_bench_paper"
    called "cmake -S .*MOAT_BUILD_TESTS=OFF"
    not_called libgtest-dev
    not_called libsundials-dev
    launch run "$script"
    code_is 0
    not_called cmake
    mkdir -p "$root/build/release/benchmarks/performance"
    printf '%s\n' '#!/bin/bash' 'echo "performance $*"' >"$root/build/release/benchmarks/performance/performance"
    chmod +x "$root/build/release/benchmarks/performance/performance"
    launch bench performance --quick
    code_is 0
    out_is "performance --quick"
    called "apt-get .*libsundials-dev"
    called "cmake -S .*MOAT_BENCH_PERFORMANCE=ON"
    called "cmake --build .*moat_bench_performance"
    cd "$world"
    records=study
    launch bench paper
    out_is "paper  with records $world/study"
    records=nowhere
    launch bench paper
    code_is 2
    err_tells "MOAT_RECORDS is nowhere, which is not a folder"
    ;;
  doctor_names_what_is_missing)
    launch doctor
    code_is 1
    out_tells "apt-get install --no-install-recommends g++ cmake"
    not_called apt-get
    launch test
    launch doctor
    code_is 0
    out_tells "missing (only for ./moat test --all)"
    ;;
  new_copies_the_first_example)
    cp "$script" "$root/examples/01_moat_wall.cpp"
    launch new "$world/mine.cpp"
    code_is 0
    cmp "$world/mine.cpp" "$script"
    ;;
  *)
    echo "there is no case $case"
    exit 2
    ;;
esac
