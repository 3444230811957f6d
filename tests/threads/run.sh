#!/usr/bin/env bash
# Runs studies of many threads with the thread sanitizer: run.sh BUILD. Exit code 1 if it finds a race of data.
set -uo pipefail
build=$(readlink -f -- "$1") here=$(readlink -f -- "$(dirname -- "${BASH_SOURCE[0]}")")
folder=$(mktemp -d)
trap 'rm -rf -- "$folder"' EXIT
cd "$folder" || exit 1
export TSAN_OPTIONS="suppressions=$here/uninstrumented.txt exitcode=66"
# The sanitizer of GCC 12 does not start where Linux places libraries at random in more than 28 bits.
plain=(setarch --addr-no-randomize)
"${plain[@]}" true 2>/dev/null || plain=()
# A record that each case reads.
{
  printf '%s\n' "SYNTHETIC" "A sine" "ACCELERATION TIME SERIES IN UNITS OF G" "NPTS= 400, DT= .0100 SEC"
  awk 'BEGIN { for (i = 0; i < 400; ++i) printf "%.6f\n", 0.2 * sin(0.05 * i) }'
} >sine.AT2
code=0
study() { # EXIT-CODE NAME OPTION...
  local expected=$1 found=0
  "${plain[@]}" "$build/tests/app/moat_study_script" --quiet --threads 4 --out "${@:2}" >log 2>&1 || found=$?
  if ((found == expected)) && ! grep -q "WARNING: ThreadSanitizer" log; then
    echo "passed: $2"
  else
    cut -c1-1000 log
    echo "FAILED: $2, exit code $found"
    code=1
  fi
}
study 0 cases --gaps 20 # with impacts, energies and error bars, into one file
study 1 failures --gaps 20 --failing 7
study 0 motions --pulses 6
study 0 suite --suite 3 # with spectra of floors and bounds of properties
study 0 files --gaps 8 --inside sine.AT2
exit "$code"
