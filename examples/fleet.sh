#!/bin/bash
# Recordings of two sisters over ten months, to try `swayaw fleet` on: the rudder of boreas is bent in June.
#
#   examples/fleet.sh PROGRAM FOLDER
set -euo pipefail
program=$(realpath "$1")
mkdir -p "$2"
cd "$2"

"$program" ship kvlcc2_l7 --out class.toml >/dev/null
{ cat class.toml; printf '\n[[effect]]\nkind = "rudder_offset"\noffset_rad = 0.02\n'; } > bent.toml

# a day: VESSEL DATE SHIP MANOEUVRE…   white noise of good instruments, the same every time
day() {
  local vessel=$1 date=$2 ship=$3
  shift 3
  mkdir -p "$vessel"
  "$program" simulate "$ship" "$@" --out track.csv >/dev/null
  awk -v date="$date" -v seed="${date//-/}" '
    function normal() { return sqrt(-2 * log(1 - rand())) * cos(6.2831853 * rand()) }
    BEGIN { FS = OFS = ","; srand(seed); print "# start_utc = \"" date "T10:00:00Z\"" }
    /^#/ { next }
    !named { for (i = 1; i <= NF; ++i) column[$i] = i; named = 1; print; next }
    (NR % 4) { next }
    {
      $column["x_m"] += 0.02 * normal(); $column["y_m"] += 0.02 * normal()
      $column["psi_rad"] += 0.001 * normal(); $column["r_rad_s"] += 0.0003 * normal()
      $column["u_m_s"] += 0.005 * normal(); $column["v_m_s"] += 0.005 * normal()
      print
    }' track.csv > "$vessel/$date.csv"
}

day athena 2026-01-14 class.toml --zigzag 20/20
day athena 2026-03-02 class.toml --turn 35
day athena 2026-05-20 class.toml --zigzag 10/10
day athena 2026-08-11 class.toml --turn 35 --first port
day athena 2026-10-05 class.toml --zigzag 20/20 --first port
day boreas 2026-01-30 class.toml --zigzag 10/10
day boreas 2026-03-18 class.toml --zigzag 20/20
day boreas 2026-05-07 class.toml --turn 35
day boreas 2026-07-01 bent.toml --zigzag 20/20 --first port
day boreas 2026-08-23 bent.toml --zigzag 10/10
day boreas 2026-10-19 bent.toml --turn 35 --first port
rm track.csv
