#!/usr/bin/env bash
# Runs fuzz targets, all or those named: run.sh BUILD OPTION [TARGET...]. OPTION is -runs=N or -max_total_time=SECONDS.
#
# Inputs begin with the seeds of the target, and with real files in the folders MOAT_FORMATS and MOAT_RECORDS. New ones
# that reach more code are kept in BUILD/corpus; one that crashes, throws, takes longer than 5 s or more than 1 GB is
# kept in BUILD/found, and makes the exit code 1.
set -uo pipefail
build=$(readlink -f -- "$1") option=$2
cd "$(dirname -- "${BASH_SOURCE[0]}")" || exit 1
shift 2
programs=$build/tests/fuzz
if (($# == 0)); then
  mapfile -t targets < <(cd "$programs" && find . -maxdepth 1 -name 'moat_fuzz_*' -type f -printf '%f\n' | sort |
    sed -n '/_seeds$/d; s/^moat_fuzz_//p')
  set -- "${targets[@]}"
fi
mkdir -p "$build/corpus" "$build/found"
"$programs/moat_fuzz_seeds" "$build/seeds" || exit 1
code=0
for target in "$@"; do
  [[ -x $programs/moat_fuzz_$target ]] || { echo "There is no target $target." >&2 && exit 2; }
  mkdir -p "$build/corpus/$target"
  folders=("$build/corpus/$target" "$build/seeds/$target")
  if [[ $target == record ]]; then # long files take their time and reach no other code
    rm -rf "$build/real" && mkdir "$build/real"
    for folder in "${MOAT_FORMATS-}" "${MOAT_RECORDS-}"; do
      [[ ! -d $folder ]] || find "$folder" -maxdepth 1 -type f -size -200k -exec ln -st "$build/real" {} +
    done
    folders+=("$build/real")
  fi
  log=$build/found/$target.log
  # Memory that is taken at once counts against -malloc_limit_mb.
  "$programs/moat_fuzz_$target" "$option" -timeout=5 -malloc_limit_mb=1000 -rss_limit_mb=4000 -max_len=1000000 \
    -dict=words.dict -artifact_prefix="$build/found/$target-" -print_final_stats=1 "${folders[@]}" >"$log" 2>&1 &
  if wait $!; then
    echo "$target: $(sed -n 's/^stat::number_of_executed_units: *//p' "$log") executions, nothing found"
  else
    echo "$target: FAILED, $(grep -m1 'SUMMARY' "$log")"
    rm -rf "/dev/shm/moat_fuzz_$!" "/tmp/moat_fuzz_$!" # its files
    code=1
  fi
done
exit $code
