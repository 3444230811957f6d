#!/usr/bin/env bash
# paraview_test.sh LINE_SCRIPT PLAN_SCRIPT UNPACKED: ParaView reads the frames and tables of both scripts, and moat.py
# beside them draws pictures. Debian's python3-paraview cannot be installed beside VTK; it may lie unpacked in the folder
# UNPACKED, with the libexpat of Debian's security updates, by which ParaView reads XML.
set -euo pipefail

line_script=$1
plan_script=$2
unpacked=$3
checks=$(cd -- "$(dirname -- "$0")" && pwd)/paraview_check.py

skip() {
  printf 'paraview_test.sh: Skipped\n%s\n\n' "$1"
  exit 77
}
command -v pvbatch >/dev/null || skip "install paraview to draw the frames"
command -v xvfb-run >/dev/null || skip "install xvfb and xauth to draw the frames without a screen"
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
export HOME=$folder
# -noreset: without it the screen restarts when ParaView ends its first connection, with which it only
# queries the screen; a second connection at that moment is refused.
pvbatch_on_screen() {
  PYTHONPATH=$unpacked/usr/lib/python3/dist-packages LD_LIBRARY_PATH=$(dirname "$expat") \
    xvfb-run -a -s "-screen 0 1280x1024x24 -noreset" pvbatch "$@"
}
expat=$(find "$unpacked" -name libexpat.so.1 2>/dev/null) || true
[[ -n $expat ]] || skip "unpack libexpat1 to draw the frames"
echo 'from paraview.simple import PVDReader' >import.py
pvbatch_on_screen import.py >python.log 2>&1 || skip "unpack python3-paraview to draw the frames"

"$line_script" --end "4 s" --frame-interval "20 ms" --out line --quiet
"$plan_script" --end "6 s" --frame-interval "50 ms" --out plan --quiet
draw() {
  pvbatch_on_screen "$@" >draw.log 2>&1 || { cat draw.log && exit 1; }
}
for results in line plan; do
  draw "$results/moat.py" --picture "$folder/$results.png" --time 3.4 --size 640 480
  draw "$results/moat.py" --picture "$folder/$results-drift.png" --field Drift --size 640 480
  draw "$checks" "$results/frames.pvd" "$results.png" "$results-drift.png"
  [[ -s checked ]] || { cat draw.log && exit 1; }
  rm checked
done
[[ -z ${MOAT_PICTURES-} ]] || cp ./*.png "$MOAT_PICTURES"
