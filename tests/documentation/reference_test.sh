#!/usr/bin/env bash
# reference_test.sh SOURCE DOXYFILE: no symbol of an installed header is undocumented, and no comment is malformed.
set -euo pipefail

source=$1
doxyfile=$2
if ! command -v doxygen >/dev/null; then
  printf 'reference_test.sh: Skipped\ninstall doxygen to count undocumented symbols\n\n'
  exit 77
fi
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
{
  cat "$doxyfile"
  printf 'OUTPUT_DIRECTORY = "%s/reference"\nWARN_LOGFILE = "%s/warnings"\n' "$folder" "$folder"
} >"$folder/Doxyfile"
cd "$source"
doxygen "$folder/Doxyfile" >/dev/null
pages=$(find "$folder/reference/html" -name '*.html' | wc -l)
((pages > 100)) || { echo "FAILED: there are only $pages pages" && exit 1; }
# Every installed header is read.
build=$(dirname "$doxyfile")
cmake --install "$build" --prefix "$folder/installed" >/dev/null
installed=$(find "$folder/installed/include/moat" -name '*.hpp' | wc -l)
read=$(sed -n 's/^INPUT  *= //p' "$doxyfile" | wc -w)
((read == installed)) || { echo "FAILED: $read headers are read and $installed are installed" && exit 1; }
if [[ -s $folder/warnings ]]; then
  echo "FAILED: $(wc -l <"$folder/warnings") warnings"
  cat "$folder/warnings"
  exit 1
fi

# A symbol without a comment is found.
mkdir "$folder/own"
printf '// A header.\n#pragma once\n/// Documented.\nstruct Known {\n  int undocumented = 0;\n};\n' >"$folder/own/own.hpp"
{
  cat "$folder/Doxyfile"
  printf 'INPUT = "%s/own/own.hpp"\nWARN_LOGFILE = "%s/own/warnings"\n' "$folder" "$folder"
} >"$folder/own/Doxyfile"
doxygen "$folder/own/Doxyfile" >/dev/null
grep -q "undocumented" "$folder/own/warnings" || { echo "FAILED: an undocumented symbol was not found" && exit 1; }
