#!/usr/bin/env bash
# code_blocks_test.sh BUILD DOCUMENT.md: every C++ block of a document compiles, and its whole scripts run. They are
# compiled as `moat run` compiles scripts.
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
bash "$here/hospital_files.sh" .
for script in script_*.cpp; do
  [[ -e $script ]] || break
  "${compile[@]}" "$script" -o "${script%.cpp}" "${link[@]}"
  options=(--quiet --out results)
  # Studies have no end and no frames.
  if ! grep -q "script.study\|script.suite" "$script"; then options+=(--force --end "0.2 s" --frame-interval "0 s"); fi
  "./${script%.cpp}" "${options[@]}" || { echo "FAILED: $script of $document" && exit 1; }
  [[ -s results/report.html ]] || { echo "FAILED: $script left no report" && exit 1; }
  if grep -q 'design_sheet' "$script"; then bash "$here/hospital_test.sh" "$script" results; fi
  rm -r results
done
