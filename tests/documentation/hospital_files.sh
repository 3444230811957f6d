#!/usr/bin/env bash
# hospital_files.sh FOLDER: writes the files that the hospital of docs/how-to/cookbook.md reads: storeys.csv, outlines.csv, and
# seven pairs of records in records/, which are pulses of growing period under a bell.
set -euo pipefail

cd -- "$1"
{
  printf '%s,' "name" "height [m]" "mass [t]" "inertia [t m2]" "x_rigidity [m]" "y_rigidity [m]" "kx [kN/m]" "ky [kN/m]"
  echo "k_rotation [kN m],outline"
  echo "base,,600,93600,,,,,,tower"
  for floor in {1..12}; do echo "floor $floor,3.6,600,93600,0,0.5,1.6e6,1.5e6,350e6,tower"; done
} >storeys.csv
printf '%s\n' "name,x [m],y [m]" tower,-18,-12 tower,18,-12 tower,18,12 tower,-18,12 >outlines.csv
mkdir -p records
for number in {1..7}; do
  for azimuth in 000 090; do
    awk -v number="$number" -v azimuth="$azimuth" 'BEGIN {
      pi = atan2(0, -1); step = 0.01; count = 2000
      period = azimuth == "000" ? 0.8 + 0.25 * number : 1.2 + 0.35 * (number - 1)
      for (i = 0; i <= count; ++i) {
        t = i * step - 1 - period
        bell = t < -period || t > period ? 0 : 0.5 * (1 + cos(pi * t / period))
        speed[i] = bell * cos(2 * pi * t / period)  # m/s
      }
      print "PEER NGA STRONG MOTION DATABASE RECORD"
      printf "Synthetic, 1/1/2000, Station %d, %d\n", number, azimuth
      print "ACCELERATION TIME SERIES IN UNITS OF G"
      printf "NPTS= %d, DT= %.4f SEC\n", count, step
      for (i = 0; i < count; ++i) printf "%15.7E%s", (speed[i + 1] - speed[i]) / step / 9.80665, i % 5 == 4 ? "\n" : ""
    }' >"records/RSN${number}_STATION${azimuth}.AT2"
  done
done
