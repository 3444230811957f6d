#!/usr/bin/env bash
# bootstrap_test.sh CHECKOUT CASE: one test of the script `moat`.
#
# A copy of the script in a small tree of its own meets stand-ins for apt-get, dpkg-query, sudo and cmake, which write
# down how they were called. The stand-in for cmake "builds" a program that prints its arguments.
set -euo pipefail

checkout=$1
case=$2

world=$(mktemp -d)
trap 'chmod -R u+w "$world"; rm -rf "$world"' EXIT
root="$world/the checkout"
calls=$world/calls
export HOME=$world/home
unset XDG_CACHE_HOME
mkdir -p "$root/src/launcher" "$world/bin" "$HOME"
cp "$checkout/moat" "$root/"
cp -r "$checkout/cmake" "$root/"
cp "$checkout/src/launcher/help.hpp" "$root/src/launcher/"
touch "$world/installed" "$calls" "$world/tower.cpp"
# shellcheck disable=SC2016 # the stand-ins expand these themselves
{
  program() { cat >"$world/bin/$1" && chmod +x "$world/bin/$1"; }
  program dpkg-query <<<'#!/bin/bash
    for package in "$@"; do grep -qx -- "$package" "$WORLD/installed" && echo "installed $package"; done; true'
  program apt-get <<<'#!/bin/bash
    echo "apt-get $*" >>"$WORLD/calls"
    case $* in
      *--yes*assume-no*) echo "--yes wins over --assume-no" >&2; exit 1 ;;
      *assume-no*) echo "0 upgraded, 14 newly installed, 0 to remove."; echo "Need to get 2,048 kB/531 MB of archives." ;;
      *install*) printf "%s\n" "$@" >>"$WORLD/installed" ;;
    esac'
  program cmake <<<'#!/bin/bash
    [[ $1 != --version ]] || exit 0
    echo "cmake $*" >>"$WORLD/calls"
    case $1 in
      --build)
        [[ ! -e $WORLD/build_fails ]] || { echo "the reason why"; exit 1; }
        mkdir "$WORLD/building" || { echo "two build at the same time"; exit 1; }
        sleep 0.2; rmdir "$WORLD/building" # long enough for another one to come along
        mkdir -p "$2/bin"; cp "$WORLD/program" "$2/bin/moat" ;;
      -S)
        mkdir -p "$4"; touch "$4/build.ninja"
        echo "CMAKE_HOME_DIRECTORY:INTERNAL=$2" >"$4/CMakeCache.txt" ;;
    esac'
  program sudo_without_password <<<'#!/bin/bash
    [[ $1 != --non-interactive ]] || exit 0
    echo "sudo $*" >>"$WORLD/calls"; exec "$@"'
  printf '%s\n' '#!/bin/bash' '[[ ! -e $3/.lock ]] || flock --timeout 5 "$3/.lock" true || echo "The lock is still held."' \
    'printf "[%s]" "$@"; echo; exit 7' >"$world/program"
  chmod +x "$world/program"
}

# launch WORD...: leaves the exit code in $code and the output in $out and $err.
as_user=()
shell=()
launch() {
  code=0
  : >"$calls"
  env PATH="$world/bin:$PATH" WORLD="$world" ${as_user[@]+"${as_user[@]}"} ${shell[@]+"${shell[@]}"} "$root/moat" "$@" \
    >"$world/out" 2>"$world/err" </dev/null || code=$?
  out=$(<"$world/out")
  err=$(<"$world/err")
}

fail() {
  printf 'FAILED: %s\n--- exit code %s\n--- output\n%s\n--- errors\n%s\n--- calls\n%s\n' \
    "$1" "$code" "$out" "$err" "$(<"$calls")"
  exit 1
}
code_is() { [[ $code == "$1" ]] || fail "the exit code should be $1"; }
out_is() { [[ $out == "$1" ]] || fail "the output should be: $1"; }
out_has() { [[ $out == *"$1"* ]] || fail "the output should have: $1"; }
err_has() { [[ $err == *"$1"* ]] || fail "the errors should have: $1"; }
called() { grep -q -- "$1" "$calls" || fail "should have called: $1"; }
not_called() { ! grep -q -- "$1" "$calls" || fail "should not have called: $1"; }
handed_over() { out_is "[$root][$1/release][$1][run][$world/tower.cpp]" && code_is 7; }

# Tests for the real CTest.
write_tests() {
  mkdir -p "$root/build/release"
  cat >"$root/build/release/CTestTestfile.cmake" <<'END'
add_test(passes true)
foreach(test one two)
  add_test(${test} printf "x_test.cpp:7: Skipped\\nSet MOAT_RECORDS to the <folder> of records.\\n\\n[  SKIPPED ] X (0 ms)\\n")
  set_tests_properties(${test} PROPERTIES SKIP_REGULAR_EXPRESSION "SKIPPED")
endforeach()
add_test(reference bash -c "printf 'reference_test.sh: Skipped\\ndoxygen is not installed\\n\\n' && exit 77")
set_tests_properties(reference PROPERTIES SKIP_RETURN_CODE 77)
END
}

# Root may write everywhere.
become_nobody() {
  ((EUID != 0)) || as_user=(setpriv --reuid=65534 --regid=65534 --clear-groups)
  ((EUID != 0)) || chown -R 65534:65534 "$world"
}
make_read_only() {
  become_nobody
  chmod -R a-w "$root"
}

case $case in
  first_run)
    launch run "$world/tower.cpp"
    handed_over "$root/build"
    called "apt-get .*install --yes --no-install-recommends .*libtrilinos-nox-dev"
    not_called libgtest-dev
    called "cmake -S .*--preset release .*MOAT_BUILD_TESTS=OFF"
    called "cmake --build .*moat_launcher"
    err_has "14 packages, 2,048 kB to download"
    for phase in lists install configure build; do err_has "moat: $phase"; done
    launch --install test
    code_is 0
    called "install --yes .*libgtest-dev"
    ;;
  second_run_calls_nothing)
    launch run "$world/tower.cpp"
    launch run "$world/tower.cpp"
    handed_over "$root/build"
    not_called .
    [[ -z $err ]] || fail "nothing should be printed"
    ;;
  changed_launcher)
    launch run "$world/tower.cpp"
    sleep 0.01
    touch "$root/src/launcher/main.cpp"
    launch run "$world/tower.cpp"
    called "cmake --build"
    not_called "cmake -S"
    launch run "$world/tower.cpp"
    not_called .
    ;;
  moved_checkout)
    launch run "$world/tower.cpp"
    mv "$root" "$world/elsewhere"
    root=$world/elsewhere
    launch run "$world/tower.cpp"
    handed_over "$root/build"
    called "cmake -S .*--fresh"
    ;;
  configured_by_hand)
    # As `cmake --preset release` leaves it, with other options than the launcher's.
    mkdir -p "$root/build/release"
    touch "$root/build/release/build.ninja"
    echo "CMAKE_HOME_DIRECTORY:INTERNAL=$root" >"$root/build/release/CMakeCache.txt"
    launch run "$world/tower.cpp"
    handed_over "$root/build"
    not_called "cmake -S"
    called "cmake --build"
    ;;
  keeps_arguments)
    launch run "$world/tower.cpp" --gap 'two words' '' '*'
    out_is "[$root][$root/build/release][$root/build][run][$world/tower.cpp][--gap][two words][][*]"
    ;;
  waits_for_another)
    env PATH="$world/bin:$PATH" WORLD="$world" "$root/moat" run "$world/tower.cpp" >"$world/second" 2>&1 &
    launch run "$world/tower.cpp"
    handed_over "$root/build"
    wait $! || true
    grep -q "^\[.*tower.cpp\]$" "$world/second" || fail "the other one said: $(<"$world/second")"
    ! grep -q "still held" "$world/second" || fail "the other one kept the lock"
    ;;
  without_root)
    printf '%s\n' '#!/bin/bash' 'exit 1' >"$world/bin/sudo"
    chmod +x "$world/bin/sudo"
    echo "cmake" >"$world/installed"
    become_nobody
    launch run "$world/tower.cpp"
    code_is 3
    err_has "apt-get install --no-install-recommends"
    err_has " ninja-build"
    [[ $err != *" cmake"* ]] || fail "cmake is installed"
    not_called .
    ;;
  with_sudo)
    mv "$world/bin/sudo_without_password" "$world/bin/sudo"
    become_nobody
    export http_proxy=http://proxy.example:3128
    launch run "$world/tower.cpp"
    code_is 7
    ((EUID != 0)) || called "sudo env http_proxy=http://proxy.example:3128 .*apt-get .*install"
    ;;
  without_apt)
    # Only the tools that the script itself needs are on the PATH.
    for tool in bash env cat dirname flock grep mkdir paste readlink; do
      ln -s "$(command -v "$tool")" "$world/bin/$tool"
    done
    rm "$world"/bin/{apt-get,dpkg-query,cmake}
    PATH=$world/bin
    launch run "$world/tower.cpp"
    PATH=/usr/bin:/bin
    code_is 3
    err_has "This is not Debian"
    err_has "libtrilinos-nox-dev"
    ;;
  build_fails)
    touch "$world/build_fails"
    launch run "$world/tower.cpp"
    code_is 1
    err_has "the reason why"
    err_has "$root/build/logs/build.log"
    rm "$world/build_fails"
    launch run "$world/tower.cpp"
    handed_over "$root/build"
    ;;
  help_before_the_program)
    for arguments in "--help" "-h" "help" "run --help" "test -h"; do
      # shellcheck disable=SC2086 # several words on purpose
      launch $arguments
      code_is 0
      out_has "./moat run examples/01_moat_wall.cpp"
      not_called .
    done
    ;;
  doctor_before_the_program)
    launch doctor
    code_is 1
    out_has "libtrilinos-nox-dev"
    out_has "not built yet"
    not_called .
    # Packages for tests alone are no fault.
    grep -hv '^#' "$root"/cmake/packages/run.txt >"$world/installed"
    launch doctor
    code_is 0
    out_has "missing (only for ./moat test)"
    ;;
  wrong_usage_before_the_program)
    for arguments in "" "frobnicate" "run" "run $world/no.cpp" "new" "bench"; do
      # shellcheck disable=SC2086
      launch $arguments
      code_is 2
      [[ -n $err && -z $out ]] || fail "a sentence on standard error is missing"
      not_called .
    done
    ;;
  read_only_checkout)
    grep -hv '^#' "$root"/cmake/packages/*.txt >"$world/installed"
    make_read_only
    launch run "$world/tower.cpp"
    handed_over "$HOME/.cache/moat/${root//\//%}"
    [[ $(stat -c %a "$HOME/.cache/moat" "$HOME/.cache/moat/${root//\//%}") == $'700\n700' ]] ||
      fail "the cache is open to others"
    launch run "$world/tower.cpp"
    not_called .
    export XDG_CACHE_HOME="$HOME/other"
    launch run "$world/tower.cpp"
    handed_over "$HOME/other/moat/${root//\//%}"
    ;;
  built_read_only_checkout)
    launch run "$world/tower.cpp"
    sleep 0.01
    touch "$root/src/launcher/main.cpp"
    make_read_only
    work=$HOME/.cache/moat/${root//\//%}
    launch run "$world/tower.cpp"
    out_is "[$root][$root/build/release][$work][run][$world/tower.cpp]"
    not_called .
    launch test
    out_is "[$root][$work/release][$work][test]"
    ;;
  no_folder_to_write)
    make_read_only
    for home in HOME=/dev/null --unset=HOME; do
      as_user=(${as_user[@]+"${as_user[@]}"} env "$home")
      launch run "$world/tower.cpp"
      code_is 1
      err_has "moat: Neither $root/build nor "
      err_has "Set XDG_CACHE_HOME to a folder that can be written."
      [[ $err != *mkdir* && $err != *$'\n'* ]] || fail "one sentence should be printed"
    done
    err_has "HOME is not set"
    ;;
  called_by_sh)
    shell=(sh)
    launch run "$world/tower.cpp"
    handed_over "$root/build"
    ;;
  reasons_of_skipped_tests)
    write_tests
    launch --test some
    code_is 0
    out_has "2 skipped: Set MOAT_RECORDS to the <folder> of records."
    out_has "1 skipped: doxygen is not installed"
    ;;
  nothing_may_be_skipped)
    write_tests
    : >"$root/cmake/packages/unpacked.txt"
    launch --test all
    code_is 1
    out_has "With --all a skipped test is a failure."
    launch --test all -R passes
    code_is 0
    ;;
  checks_go_on)
    git -C "$root" init --quiet
    touch "$root/bad.sh"
    git -C "$root" add bad.sh
    printf '#!/bin/sh\necho "$@"; exit 1\n' >"$world/bin/shellcheck"
    printf '#!/bin/sh\n' >"$world/bin/clang-format"
    chmod +x "$world/bin/shellcheck" "$world/bin/clang-format"
    launch --check shell format
    code_is 1
    out_has "bad.sh"
    err_has "Checks that failed: shell"
    launch --check format
    code_is 0
    err_has "All checks passed: format"
    ;;
  *)
    echo "there is no case $case"
    exit 2
    ;;
esac
