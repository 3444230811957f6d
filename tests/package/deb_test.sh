#!/usr/bin/env bash
# deb_test.sh BUILD: makes the Debian package, unpacks it into a folder, and compiles and runs scripts with nothing but
# this folder.
set -euo pipefail

build=$1
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
export HOME=$folder/home
unset XDG_CACHE_HOME MOAT_SCRIPT

fail() {
  echo "FAILED: $1"
  exit 1
}
if ! command -v dpkg-deb >/dev/null; then
  printf 'deb_test.sh: Skipped\nthis is not Debian: there is no dpkg-deb\n\n'
  exit 77
fi

# The same as `cpack -G DEB`, but without a build.
cmake --install "$build" --prefix "$folder/stage/usr" >install.log
cpack -G DEB --config "$build/CPackConfig.cmake" -B "$folder/made" -D CPACK_INSTALL_CMAKE_PROJECTS= \
  -D "CPACK_INSTALLED_DIRECTORIES=$folder/stage;/" >cpack.log 2>&1 || { cat cpack.log && fail "cpack"; }
packages=("$folder"/made/moat_*.deb)
[[ -s ${packages[0]} ]] || fail "there is no package"
depends=$(dpkg-deb -f "${packages[0]}" Depends)
dpkg-deb -x "${packages[0]}" root
rm -r stage
# It depends on the compiler, and on every library that its programs name.
needed=$(find root/usr/lib -type f \( -name '*.so*' -o -path '*/bin/*' \) -exec objdump -p {} + |
  sed -n 's/^ *NEEDED *//p' | grep -v '^libmoat' | sort -u)
for library in $needed; do
  file=$(readlink -f "$(PATH=$PATH:/sbin ldconfig -p | sed -n "s|^\s*$library .* => ||p" | head -n 1)")
  # dpkg knows a file of /usr/lib by the name that it has in its package, /lib/... for some.
  owner=$({ dpkg -S "$file" || dpkg -S "${file#/usr}"; } 2>/dev/null | cut -d : -f 1)
  owners+=" ${owner:-unknown:$library}"
done
for package in g++ libeigen3-dev libjs-dygraphs ${owners:?no library was found}; do
  [[ ", $depends," =~ ", $package"(","|" (") ]] || fail "the package does not depend on $package: $depends"
done
# It carries the notices of the code inside it, and keeps compiled scripts from others.
for notice in "the moat authors" CLI11 "Niels Lohmann" Eigen "Nemanja Trifunovic" Boost "GNU C library" dygraphs; do
  grep -q "$notice" root/usr/share/doc/moat/copyright || fail "the notice of $notice is missing"
done
# Nothing names the folder that the library was built in, or the one it was staged in.
for text in root/usr/lib*/moat/*.txt root/usr/bin/moat; do
  ! grep -e "$build" -e "$folder" "$text" || fail "$text names another place"
done

moat=$folder/root/usr/bin/moat
"$moat" new tower 2>new.log
grep -q "Run it with: moat run tower.cpp" new.log || { cat new.log && fail "moat new"; }
[[ $(stat -c %a "$HOME/.cache/moat" "$HOME/.cache/moat/installed") == $'700\n700' ]] || fail "the cache is open to others"
run() {
  "$moat" run tower.cpp --end "0.5 s" --out out --force >run.log 2>&1 || { cat run.log && fail "moat run tower.cpp"; }
}
run
[[ -s out/summary.json ]] || fail "the script left no results"
# The header is precompiled at the first script, and again after an installation; so is the script.
grep -q "header .*once" run.log || { cat run.log && fail "the header was not precompiled"; }
run
! grep -q "header\|compile" run.log || { cat run.log && fail "an unchanged script was compiled again"; }
sleep 0.1
touch root/usr/lib*/moat/bin/moat
run
for made in "header .*once" "compile .*tower"; do
  grep -q "$made" run.log || { cat run.log && fail "the package is newer, and the log lacks: $made"; }
done
"$moat" report out | grep -q "report.html" || fail "moat report"
"$moat" new mine --project 2>project.log
grep -q "moat_add_script(mine.cpp)" mine/CMakeLists.txt || fail "moat new --project"
printf '%s\n' "SYNTHETIC" "Test" "ACCELERATION TIME SERIES IN UNITS OF G" "NPTS= 3, DT= .01 SEC" "0. .1 0." >a.AT2
"$moat" motion a.AT2 | grep -q "0.1 g" || fail "moat motion"

# The help names the installed command and its examples; all that it names is there.
"$moat" --help >help.log
! grep -F "./moat" help.log || fail "the help calls a checkout"
example=$(sed -n 's/^ *moat run \([^ ]*\) .*first tour.*/\1/p' help.log)
[[ -s $example ]] || fail "the first tour of the help is not there: $example"
"$moat" doctor >doctor.log || { cat doctor.log && fail "moat doctor"; }
"$folder/root/usr/share/moat/moat" doctor >doctor.log || fail "share/moat/moat, which studies name to go on"
PATH=$folder/root/usr/bin:$PATH bash -c 'source "$1" && complete -p moat' bash \
  root/usr/share/bash-completion/completions/moat >completion.log || fail "completion"

# Errors are explained with the headers of the package.
sed 's/\.floor_mass =/.floor_masses =/' tower.cpp >wrong.cpp
! "$moat" run wrong.cpp 2>wrong.log || fail "a wrong script was compiled"
grep -q "did you mean floor_mass" wrong.log || { cat wrong.log && fail "the error was not explained"; }
! "$moat" test 2>test.log || fail "moat test without sources"
grep -q "needs the sources" test.log || { cat test.log && fail "moat test does not say that it needs the sources"; }
