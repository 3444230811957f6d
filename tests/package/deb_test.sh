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

# What `cpack -G DEB` does, without building anything on the way.
cmake --install "$build" --prefix "$folder/stage/usr" >install.log
cpack -G DEB --config "$build/CPackConfig.cmake" -B "$folder/made" -D CPACK_INSTALL_CMAKE_PROJECTS= \
  -D "CPACK_INSTALLED_DIRECTORIES=$folder/stage;/" >cpack.log 2>&1 || { cat cpack.log && fail "cpack"; }
packages=("$folder"/made/moat_*.deb)
[[ -s ${packages[0]} ]] || fail "there is no package"
depends=$(dpkg-deb -f "${packages[0]}" Depends)
for package in g++ ninja-build libeigen3-dev; do
  [[ $depends == *"$package"* ]] || fail "the package does not depend on $package: $depends"
done
dpkg-deb -x "${packages[0]}" root
rm -r stage
# Nothing names the folder that the library was built in, or the one it was staged in.
for text in root/usr/lib*/moat/*.txt root/usr/bin/moat; do
  ! grep -e "$build" -e "$folder" "$text" || fail "$text names another place"
done

moat=$folder/root/usr/bin/moat
"$moat" new tower.cpp 2>new.log
"$moat" run tower.cpp --end "0.5 s" --out out >run.log 2>&1 || { cat run.log && fail "moat run tower.cpp"; }
[[ -s out/summary.json ]] || fail "the script left no results"
"$moat" report out | grep -q "report.html" || fail "moat report"
"$moat" new mine --project 2>project.log
grep -q "moat_add_script(mine.cpp)" mine/CMakeLists.txt || fail "moat new --project"
printf '%s\n' "SYNTHETIC" "Test" "ACCELERATION TIME SERIES IN UNITS OF G" "NPTS= 3, DT= .01 SEC" "0. .1 0." >a.AT2
"$moat" motion a.AT2 | grep -q "0.1 g" || fail "moat motion"

# Errors are explained with the headers of the package.
sed 's/\.floor_mass =/.floor_masses =/' tower.cpp >wrong.cpp
! "$moat" run wrong.cpp 2>wrong.log || fail "a wrong script was compiled"
grep -q "did you mean floor_mass" wrong.log || { cat wrong.log && fail "the error was not explained"; }
! "$moat" test 2>test.log || fail "moat test without sources"
grep -q "needs the sources" test.log || { cat test.log && fail "moat test does not say that it needs the sources"; }
