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
read=$(sed -n 's/^INPUT  *= //p' "$doxyfile" | grep -o '[^ ]*\.hpp' | wc -l)
((read == installed)) || { echo "FAILED: $read headers are read and $installed are installed" && exit 1; }
if [[ -s $folder/warnings ]]; then
  echo "FAILED: $(wc -l <"$folder/warnings") warnings"
  cat "$folder/warnings"
  exit 1
fi

# Doxygen finds nothing missing in a namespace that is not documented itself.
grep -rhoE '^namespace [a-z_:]+' "$folder/installed/include/moat" | cut -d ' ' -f 2 | sort -u >"$folder/namespaces"
while read -r namespace; do
  [[ $namespace == detail ]] || grep -qxE "/// .namespace (moat::)?$namespace" docs/namespaces.dox ||
    { echo "FAILED: docs/namespaces.dox lacks $namespace" && exit 1; }
done <"$folder/namespaces"

# A symbol without a comment is found.
mkdir "$folder/own"
cat >"$folder/own/own.hpp" <<'END'
#pragma once
namespace moat {
/// Documented.
struct Known {
  int undocumented_member = 0;
};
void undocumented_function();
enum class UndocumentedChoice {};
using UndocumentedAlias = Known;
}  // namespace moat
END
{
  cat "$folder/Doxyfile"
  printf 'INPUT = "%s/own/own.hpp" docs/namespaces.dox\nWARN_LOGFILE = "%s/own/warnings"\n' "$folder" "$folder"
} >"$folder/own/Doxyfile"
doxygen "$folder/own/Doxyfile" >/dev/null
for symbol in undocumented_member undocumented_function UndocumentedChoice UndocumentedAlias; do
  grep -q "$symbol" "$folder/own/warnings" || { echo "FAILED: $symbol, without a comment, was not found" && exit 1; }
done
