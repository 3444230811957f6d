#!/usr/bin/env bash
# Runs all tests with the sanitizers, and prints how many lines they reach: run.sh ASAN BUILD [options of ctest].
#
# ASAN is a build of the library by the preset `asan`, and BUILD the finished build of all tests, which load that library
# instead of their own. The launcher's tests have the sanitizers too, because they do not load the library.
#
# Exit code 1 if a test fails, if the library leaks memory, or if less than 90 % of all lines of the library or 95 % of
# those of the parsers (parsers.txt) are reached. ASAN/coverage.csv has every file, ASAN/uncovered.txt the lines that no
# test reached.
set -uo pipefail
asan=$(readlink -f -- "$1") build=$(readlink -f -- "$2") here=$(readlink -f -- "$(dirname -- "${BASH_SOURCE[0]}")")
shift 2
cd "$here/../.." || exit 1
find "$asan" -name '*.gcda' -delete
rm -rf "$asan/reports" && mkdir "$asan/reports"
# Programs of others, such as compilers, leak memory.
export ASAN_OPTIONS=log_path=$asan/reports/of LSAN_OPTIONS=exitcode=0
code=0
"$asan/tests/launcher/moat_launcher_tests" --gtest_brief=1 || code=1
# Sanitizers keep freed memory, and take more address space than any limit. Chromium and compilers are not tested here.
left_out='MemoryBounds|MemoryLimits|MemoryIsTooSmall|InABrowser|^(package|compile_failures|launcher)\.'
LD_PRELOAD=$(c++ -print-file-name=libasan.so) LD_LIBRARY_PATH=$asan/src \
  ctest --test-dir "$build" --output-on-failure --no-tests=error --parallel "$(nproc)" -E "$left_out" "$@" |
  sed -E '/ Start +[0-9]+:| Passed /d' || code=1
for report in "$asan"/reports/*; do
  grep -Eq 'ERROR: AddressSanitizer|libmoat' "$report" || continue
  cat "$report"
  code=1
done
# Tests of the launcher and of documents compile scripts in folders that are gone: their lines are no product.
gcovr --root . --object-directory "$asan" --gcov-ignore-parse-errors --exclude-unreachable-branches \
  --exclude-directories '.*CompilerId.*' --filter '(src|materials|elements|structures|analyses)/' -j "$(nproc)" \
  --csv "$asan/coverage.csv" --txt "$asan/uncovered.txt" "$asan" || exit 1
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
  }' "$asan/coverage.csv" || code=1
exit "$code"
