#!/usr/bin/env bash
# hospital_test.sh SCRIPT RESULTS: the hospital of docs/how-to/cookbook.md has at most 40 lines, as clang-format sets them,
# and left its spectra and its sheet.
set -euo pipefail

script=$1
results=$2
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

sed '1,/^#line/d' "$script" >"$folder/block.cpp"
cp "$(dirname -- "$0")/../../.clang-format" "$folder"
if command -v clang-format-14 >/dev/null; then
  clang-format-14 "$folder/block.cpp" | diff "$folder/block.cpp" - || { echo "FAILED: it is not formatted" && exit 1; }
fi
(($(wc -l <"$folder/block.cpp") <= 40)) || { echo "FAILED: it has more than 40 lines" && exit 1; }
for floor in base "floor 6" "floor 12"; do
  grep -q "^floor_sa,\"$floor, x, 5 %, [0-9.]* s\",m/s^2,bounds = lower,7," "$results/suite_statistics.csv" ||
    { echo "FAILED: there are no spectra of $floor" && exit 1; }
done
grep -q "clearance 0.9 m .* D<sub>TM,dyn</sub>" "$results/design_sheet.html" ||
  { echo "FAILED: there is no sheet with histories" && exit 1; }
