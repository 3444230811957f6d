#!/usr/bin/env bash
# Kill, disk and fault trials of runs and studies: run.sh BUILD [TRIAL...]. Takes at most 4 minutes.
#
# After each fault: the exit code of docs/reference/scripts.md, whole files, a mark where results are incomplete, files of the user
# as they were, and a further run that completes. Exit code 1 if anything of this fails.
# shellcheck disable=SC2317,SC2015 # trials are called by their names; the command between && and || does not fail
set -uo pipefail
build=$(readlink -f -- "$1")
shift
run=$build/examples/01_moat_wall study=$build/tests/app/moat_study_script export=$build/bin/moat_study
valid=$build/tests/faults/moat_valid_results shim=$build/tests/faults/libmoat_failing_calls.so
folder=$(mktemp -d)
trap 'rm -rf -- "$folder"' EXIT
RANDOM=1
failures=0 faults=0
# A run of half a second, one of several, and a study of 120 cases, of two seconds.
own=(env --default-signal=INT) # which a shell ignores for commands in the background
short=("${own[@]}" "$run" --quiet --end "4 s" --frame-interval "0.5 s" --out)
long=("${own[@]}" "$run" --quiet --step "4e-5 s" --frame-interval "50 ms" --out)
cases=("${own[@]}" MOAT_TEST_LOG=log "$study" --quiet --gaps 60 --threads 2 --out study)

fail() {
  echo "FAILED: $trial: $*"
  failures=$((failures + 1))
}
expect_code() { [[ " $2 " == *" $1 "* ]] || fail "exit code $1, not $2: $(tail -n 2 errors 2>/dev/null)"; }
# The words of valid_results on some folders: expect_valid WORDS FOLDER...
expect_valid() {
  local words=$1 found
  shift
  found=$("$valid" "$@") || fail "$(grep torn <<<"$found")"
  while read -r found; do
    [[ $found == torn* || " $words " == *" $found "* ]] || fail "$* is $found, not $words"
  done <<<"$found"
}
keep_mine() { mkdir -p "${1:-.}" && echo mine >"${1:-.}/notes.txt" && echo mine >"${1:-.}/other.csv"; }
expect_mine() { [[ $(cat "${1:-.}/notes.txt" "${1:-.}/other.csv") == $'mine\nmine' ]] || fail "files of the user changed"; }
between() { printf '0.%03d' "$(($1 + RANDOM % ($2 - $1)))"; } # ms
# Starts a command in the background and sends it a signal at some moment: disturbed SIGNAL FROM TO COMMAND...; `code`.
disturbed() {
  local signal=$1 moment
  moment=$(between "$2" "$3")
  shift 3
  "$@" >output 2>errors </dev/null &
  sleep "$moment"
  kill "-$signal" $! 2>/dev/null
  wait $! 2>/dev/null
  code=$?
  faults=$((faults + 1))
}
wait_for() { for _ in {1..500}; do compgen -G "$1" >/dev/null && return || sleep 0.02; done; } # a file
wait_for_cases() { for _ in {1..500}; do [[ -f log ]] && read -r -N 4 _ <log && return || sleep 0.02; done; }

# Results of a study without its times: fields of the table behind the seconds count from the end.
results_of() { "$export" export "$1" --out table.csv >/dev/null 2>errors && awk -F, -v OFS=, '{$(NF - 11) = ""} 1' table.csv; }
expect_study() { # Completes the study, and compares it with one that nothing disturbed.
  "${cases[@]}" >output 2>errors || fail "the study does not go on: $(tail -n 2 errors)"
  [[ $(results_of study) == "$undisturbed" ]] || fail "results differ from those of an undisturbed study"
}

trial_run_killed() {
  keep_mine
  for _ in {1..10}; do
    rm -rf out*
    disturbed KILL 20 999 "${long[@]}" out
    expect_code "$code" 137
    [[ ! -d out ]] || expect_valid "unfinished complete" out
  done
  "${short[@]}" out 2>errors || fail "a further run: $(cat errors)"
  expect_valid "unfinished complete" out*/
  expect_mine
}

trial_run_told_to_end() {
  local signal
  for signal in INT:130 TERM:143 HUP:129 USR1:138; do
    rm -rf out*
    "${long[@]}" out >output 2>errors &
    wait_for 'out/frames/*'
    kill "-${signal%:*}" $!
    wait $!
    expect_code $? "${signal#*:}"
    expect_valid complete out
    grep -q '"warnings": \[$' out/summary.json || fail "no warning in summary.json after $signal"
    faults=$((faults + 1))
  done
}

trial_run_goes_on() { # from its checkpoints, as often as it is killed
  local kills=0 file resume=() checked=("${own[@]}" "$run" --quiet --check --step "1e-4 s" --frame-interval "0.5 s")
  "${checked[@]}" --out whole --checkpoint "0 s" >output 2>errors || fail "the undisturbed run: $(cat errors)"
  checked+=(--out out --checkpoint "1 ms")
  while ((kills < 20)); do
    disturbed KILL 100 500 "${checked[@]}" "${resume[@]}"
    ((code == 137)) || break
    kills=$((kills + 1))
    if [[ -f out/checkpoint ]]; then resume=(--resume); else rm -rf out; fi
  done
  ((code == 0)) || "${checked[@]}" --resume 2>errors || fail "it does not go on: $(cat errors)"
  ((kills >= 10)) || fail "it was killed $kills times only"
  expect_valid complete out
  [[ ! -e out/checkpoint ]] || fail "the checkpoint stays"
  for file in histories.csv histories.vtt impacts.csv peaks.csv floor_spectra.csv frames.pvd; do
    cmp "whole/$file" "out/$file" || fail "$file differs from that of an undisturbed run"
  done
}

trial_run_paused() {
  "${short[@]}" whole
  "${short[@]}" out &
  for _ in {1..5}; do
    sleep 0.05
    kill -STOP $! 2>/dev/null
    sleep 0.05
    kill -CONT $! 2>/dev/null
    faults=$((faults + 1))
  done
  wait $! || fail "exit code $?"
  cmp whole/histories.csv out/histories.csv || fail "histories differ"
}

trial_run_full_disk() { # the k-th write and all later ones fail
  local k code
  keep_mine
  for ((k = 1, code = 1; code == 1; k += 1 + k / 8)); do # until there are fewer
    rm -rf out*
    env LD_PRELOAD="$shim" FAULT_CALL=write FAULT_AT="$k" "${short[@]}" out >output 2>errors
    code=$?
    faults=$((faults + 1))
    expect_code "$code" "0 1"
    ((code == 0)) || grep -q "No space left on device" errors || fail "the error does not say why: $(cat errors)"
    [[ ! -d out ]] || expect_valid "unfinished partial complete" out
    [[ -z $(find . -name '*.unfinished-*') ]] || fail "temporary files stay"
  done
  ((k > 20)) || fail "only the writes before the ${k}th failed"
  "${short[@]}" out 2>errors || fail "a further run: $(cat errors)"
  expect_mine
}

trial_small_disk() { # a real one
  local code size
  unshare -rm true 2>/dev/null && mkdir -p disk && unshare -rm mount -t tmpfs -o size=100k none disk 2>/dev/null ||
    { echo "skipped: small_disk: this user may not mount a small disk (unshare -rm)" && return; }
  for size in 8k 100k 400k 1m; do
    # shellcheck disable=SC2016 # the inner shell expands these itself
    unshare -rm bash -c 'mount -t tmpfs -o size=$1 none disk && "$2" --quiet --out disk/out; code=$?
      mkdir -p copy && cp -rT disk copy; exit $code' bash "$size" "$run" >output 2>errors
    code=$?
    faults=$((faults + 1))
    expect_code "$code" 1
    grep -q "No space left on device" errors || fail "the error does not say why: $(cat errors)"
    [[ ! -d copy/out ]] || expect_valid "unfinished partial complete" copy/out
    rm -rf copy
  done
}

trial_force_killed() { # while it computes, and before the k-th change of files and folders
  local k code
  "${short[@]}" out
  keep_mine out
  cp -r out old
  for _ in {1..6}; do
    disturbed KILL 20 400 "${long[@]}" out --force
    diff -r old out || fail "old results changed while the new ones were computed"
  done
  for ((k = 1, code = 137; code == 137; k += 1 + k / 8)); do # until there are fewer
    rm -rf out out.new
    cp -r old out
    env LD_PRELOAD="$shim" FAULT_CALL=change FAULT_AT="$k" "${short[@]}" out --force >output 2>errors
    code=$?
    expect_code "$code" "0 137"
    faults=$((faults + 1))
    expect_valid complete out
    expect_mine out
    "${short[@]}" out --force 2>errors || fail "killed at change $k: a further run: $(cat errors)"
    expect_valid complete out
    expect_mine out
    [[ ! -e out_2 ]] || fail "killed at change $k: the further run does not take the folder"
  done 2>/dev/null
  ((k > 10)) || fail "it was killed before the ${k}th change only"
}

trial_folder_removed() {
  "${long[@]}" out >output 2>errors &
  wait_for 'out/frames/*'
  while [[ -d out ]]; do rm -rf out 2>/dev/null; done # frames may come in between
  wait $!
  expect_code $? 1
  grep -q out errors || fail "the error does not name the folder: $(cat errors)"
  faults=$((faults + 1))
  "${short[@]}" out 2>errors || fail "a further run: $(cat errors)"
  expect_valid complete out
}

trial_closed_streams() {
  "${short[@]}" a <&- || fail "without standard input: $?"
  "${short[@]}" b >&- || fail "without standard output: $?"
  "${short[@]}" c 2>&- || fail "without standard error: $?"
  "${short[@]}" d <&- >&- 2>&- || fail "without any: $?"
  "$run" --end "4 s" --out e <&- >&- 2>&- || fail "without any, and not quiet: $?"
  "$run" --end "4 s" --out f >/dev/full 2>errors
  expect_code $? "0 1"
  expect_valid complete a b c d e f
  "${cases[@]}" >&- 2>&- <&- || fail "a study without streams: $?"
  [[ $(results_of study) == "$undisturbed" ]] || fail "a study without streams has other results"
  faults=$((faults + 7))
}

trial_runs_at_once() {
  local gap jobs=()
  for gap in 11 14 17 20; do
    "${short[@]}" out --gap "$gap cm" 2>errors &
    jobs+=($!)
  done
  for each in "${jobs[@]}"; do wait "$each" || fail "exit code $?"; done
  [[ $(echo out*) == "out out_2 out_3 out_4" ]] || fail "four runs made $(echo out*)"
  expect_valid complete out*/
  jobs=()
  keep_mine out
  for gap in 11 14 17 20; do
    "${short[@]}" out --gap "$gap cm" --force 2>"errors_$gap" &
    jobs+=($!)
  done
  for each in "${jobs[@]}"; do wait "$each" || fail "--force: exit code $?: $(cat errors_*)"; done
  expect_valid complete out*/
  expect_mine out
  for each in out*/; do # report and summary are of one run
    gap=$(grep -o '[0-9]* cm' "$each/summary.json" | head -n 1)
    grep -q "$gap" "$each/report.html" || fail "report and summary of $each are of two runs"
  done
  faults=$((faults + 2))
}

trial_study_killed() {
  local kills=0
  for _ in {1..40}; do
    disturbed KILL 20 999 "${cases[@]}"
    expect_code "$code" "0 137"
    if ((code == 137)); then kills=$((kills + 1)); else expect_study && rm -rf study; fi # and again from the first case
    ((kills < 10)) || break
  done
  ((kills == 10)) || fail "it was killed $kills times only"
  expect_study
}

trial_study_told_to_end() {
  local signal
  for signal in INT:130 TERM:143 HUP:129 USR1:138; do
    : >log
    "${cases[@]}" >output 2>errors &
    wait_for_cases
    kill "-${signal%:*}" $!
    wait $!
    expect_code $? "${signal#*:}"
    expect_valid partial study
    [[ ! -e study/study.db-wal && ! -e study/study.db.lock ]] || fail "the file is not complete by itself"
    faults=$((faults + 1))
  done
  expect_study
}

trial_study_full_disk() {
  local k code failed=0
  for k in 1 5 20 60 150 300; do
    env LD_PRELOAD="$shim" FAULT_CALL=write FAULT_AT="$k" "${cases[@]}" >output 2>errors
    code=$?
    expect_code "$code" "0 1"
    failed=$((failed + code))
    faults=$((faults + 1))
  done
  ((failed >= 5)) || fail "$failed of 6 failed"
  expect_study
}

trial_study_file_removed() {
  "${cases[@]}" >output 2>errors &
  wait_for_cases
  rm -f study/study.db*
  wait $!
  expect_code $? 1
  grep -q "the file was removed or replaced" errors || fail "the error does not say it: $(cat errors)"
  faults=$((faults + 1))
  expect_study
}

trial_studies_at_once() {
  "${cases[@]}" >output 2>errors &
  wait_for study/study.db.lock
  "${cases[@]}" >output_2 2>errors_2
  expect_code $? 1
  grep -q "another process computes it now" errors_2 || fail "the second study says: $(cat errors_2)"
  wait $! || fail "exit code $? of the first: $(cat errors)"
  faults=$((faults + 1))
  expect_study
}

trial_ranks() {
  command -v mpirun >/dev/null && compgen -G "$build/src/libmoat_mpi.so*" >/dev/null ||
    { echo "skipped: ranks: Open MPI is not installed, or moat is built without it" && return; }
  local job=(mpirun -n 3 --oversubscribe --bind-to none)
  ((EUID)) || job+=(--allow-run-as-root)
  for _ in {1..3}; do
    : >log
    MOAT_TEST_LOG=log "${job[@]}" "$study" --quiet --gaps 60 --out study >output 2>errors </dev/null &
    wait_for_cases
    pkill -KILL -P $! # its ranks
    timeout 20 tail --pid=$! -f /dev/null || fail "mpirun goes on without its ranks"
    wait $! && fail "mpirun ends with 0"
    faults=$((faults + 1))
  done
  expect_study
}

cd "$folder" && mkdir reference && cd reference || exit 1
trial=reference
"${cases[@]}" >output 2>errors || fail "the undisturbed study: $(cat errors)"
undisturbed=$(results_of study)
[[ $(wc -l <<<"$undisturbed") == 121 ]] || fail "the table of the undisturbed study has not 121 lines"

mapfile -t all < <(declare -F | sed -n 's/^declare -f trial_//p')
for trial in "${@:-${all[@]}}"; do
  mkdir "$folder/$trial" && cd "$folder/$trial" || exit 1
  begin=$SECONDS before=$failures
  "trial_$trial"
  ((failures > before)) || echo "passed: $trial, $((SECONDS - begin)) s"
done
echo "$faults faults in $SECONDS s, $failures failures"
exit $((failures > 0))
