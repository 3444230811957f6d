#!/usr/bin/env bash
# package_test.sh BUILD COMPILER: installs a build into a folder, then builds and runs a project that uses it, with
# CMake from the installed tree, with CMake from the build folder, and with pkg-config; then the project that
# `moat new --project` writes.
set -euo pipefail

build=$1
compiler=$2
consumer=$(cd -- "$(dirname -- "$0")/consumer" && pwd)
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"

fail() {
  echo "FAILED: $1"
  exit 1
}

# runs PROGRAM: prints one line, the number of impacts, which is above zero for so narrow a gap.
runs() {
  local impacts
  impacts=$("$1")
  [[ $impacts =~ ^[1-9][0-9]*$ ]] || fail "$1 printed: $impacts"
}

cmake --install "$build" --prefix "$folder/a first place" >install.log
mv "a first place" "installed tree" # a package may be moved

# Every header that an installed header includes is installed, too.
include="installed tree/include/moat"
mapfile -t included < <(grep -rhoP '^#include "\K[^"]+' "$include" | sort -u)
((${#included[@]} > 100)) || fail "only ${#included[@]} headers are included by installed headers"
for header in "${included[@]}"; do
  [[ -f $include/$header ]] || fail "$header is included by a header and not installed"
done

for place in "CMAKE_PREFIX_PATH=$folder/installed tree" "moat_DIR=$build"; do
  cmake -G Ninja -S "$consumer" -B built --fresh -DCMAKE_CXX_COMPILER="$compiler" "-D$place"
  cmake --build built --clean-first
  runs built/own_program
  built/tower --end "0.1 s" --out results
  [[ -s results/summary.json ]] || fail "the script left no results"
  rm -r results
done

# The project that `moat new` writes.
checkout=$(cd -- "$consumer/../../.." && pwd)
"$build/bin/moat" "$checkout" "$build" "$folder/cache" new own_tower --project
cmake -G Ninja -S own_tower -B own_tower/build -DCMAKE_CXX_COMPILER="$compiler" \
  "-DCMAKE_PREFIX_PATH=$folder/installed tree"
cmake --build own_tower/build
own_tower/build/own_tower --end "0.1 s" --out results
[[ -s results/summary.json ]] || fail "the new project left no results"

export PKG_CONFIG_PATH
PKG_CONFIG_PATH=$(dirname "$(find "$folder/installed tree" -name moat.pc)")
arguments=()
eval "arguments=($(pkg-config --cflags --libs moat))"
"$compiler" "$consumer/own_program.cpp" "${arguments[@]}" -o by_pkg_config
LD_LIBRARY_PATH=$(dirname "$(find "$folder/installed tree" -name libmoat.so)")
export LD_LIBRARY_PATH
runs ./by_pkg_config
