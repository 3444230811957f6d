#!/usr/bin/env bash
# code_blocks_test.sh BUILD DOCUMENT.md: every C++ block of a document compiles, and its whole scripts run. They are
# compiled as `moat run` compiles scripts. The script of the hospital has at most 40 lines, as clang-format sets them.
set -euo pipefail

build=$1
document=$2
here=$(cd -- "$(dirname -- "$0")" && pwd)
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"

mapfile -t compile <"$build/script_compile.txt"
mapfile -t link <"$build/script_link.txt"
awk -v folder="$folder" -f "$here/code_blocks.awk" "$document"

# Names of a fragment need not be used again, and hide those of fragments before it.
"${compile[@]}" -w -fsyntax-only fragments.cpp
for script in script_*.cpp; do
  [[ -e $script ]] || break
  hospital=
  if grep -q 'design_sheet' "$script"; then hospital=1; fi
  if [[ $hospital ]]; then
    bash "$here/hospital_files.sh" .
    sed '1,/^#line/d' "$script" >block.cpp
    cp "$here/../../.clang-format" .
    if command -v clang-format-14 >/dev/null; then
      clang-format-14 block.cpp | diff block.cpp - ||
        { echo "FAILED: $script of $document is not formatted" && exit 1; }
    fi
    (($(wc -l <block.cpp) <= 40)) || { echo "FAILED: $script of $document has more than 40 lines" && exit 1; }
  fi
  "${compile[@]}" "$script" -o "${script%.cpp}" "${link[@]}"
  options=(--quiet --out results)
  # Studies have no end and no frames.
  if ! grep -q "script.study\|script.suite" "$script"; then options+=(--force --end "0.2 s" --frame-interval "0 s"); fi
  if grep -q "read_record_folder" "$script"; then continue; fi
  "./${script%.cpp}" "${options[@]}" || { echo "FAILED: $script of $document" && exit 1; }
  [[ -s results/report.html ]] || { echo "FAILED: $script left no report" && exit 1; }
  if [[ $hospital ]]; then
    for floor in base "floor 6" "floor 12"; do
      grep -q "^floor_sa,\"$floor, x, 5 %, [0-9.]* s\",m/s^2,bounds = lower,7," results/suite_statistics.csv ||
        { echo "FAILED: $script has no spectra of $floor" && exit 1; }
    done
    grep -q "clearance 0.9 m .* D<sub>TM,dyn</sub>" results/design_sheet.html ||
      { echo "FAILED: $script left no sheet with histories" && exit 1; }
  fi
  rm -r results
done
