#!/usr/bin/env bash
# Runs the tests of a build of the preset `asan`, and prints how many lines they reach: run.sh BUILD [options of
# ctest].
#
# Exit code 1 if a test fails, or if less than 90 % of all lines of the library or 95 % of those of the parsers
# (parsers.txt) are reached. BUILD/coverage.csv has every file, BUILD/uncovered.txt the lines that no test reached.
set -uo pipefail
build=$(readlink -f -- "$1") here=$(readlink -f -- "$(dirname -- "${BASH_SOURCE[0]}")")
shift
cd "$here/../.." || exit 1
find "$build" -name '*.gcda' -delete
code=0
ctest --test-dir "$build" --output-on-failure --no-tests=error --parallel "$(nproc)" "$@" |
  sed -E '/ Start +[0-9]+:| Passed /d' || code=1
# Tests of the launcher and of documents compile scripts in folders that are gone: their lines are no product.
gcovr --root . --object-directory "$build" --gcov-ignore-parse-errors --exclude-unreachable-branches \
  --exclude-directories '.*CompilerId.*' --filter '(src|materials|elements|structures|analyses)/' -j "$(nproc)" \
  --csv "$build/coverage.csv" --txt "$build/uncovered.txt" "$build" || exit 1
awk -F, -v parsers="$here/parsers.txt" '
  BEGIN { while ((getline name < parsers) > 0) if (name != "" && name !~ /^#/) is_parser[name] = 1 }
  FNR == 1 { for (i = 1; i <= NF; ++i) column[$i] = i; next }
  {
    file = $column["filename"]; lines = $column["line_total"]; reached = $column["line_covered"]
    folder = file; sub("/[^/]*$", "", folder)
    all[folder] += lines; covered[folder] += reached
    all_lines += lines; all_covered += reached
    if (file in is_parser) { parser_lines += lines; parser_covered += reached; delete is_parser[file] }
  }
  function row(name, covered, all) {
    return sprintf("%6.1f %%  %6d of %6d  %s", 100 * covered / all, covered, all, name)
  }
  END {
    for (folder in all) if (all[folder] > 0) print row(folder, covered[folder], all[folder]) | "sort -k 6"
    close("sort -k 6")
    for (name in is_parser) { print "No line of the parser " name " was compiled."; failed = 1 }
    if (parser_lines > 0) print row("parsers (tests/coverage/parsers.txt)", parser_covered, parser_lines)
    print row("the library", all_covered, all_lines)
    exit failed || all_covered < 0.90 * all_lines || parser_covered < 0.95 * parser_lines
  }' "$build/coverage.csv" || code=1
exit "$code"
