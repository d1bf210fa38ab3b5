#!/usr/bin/env bash
# Makes the tables of docs/results/esso_osaka_diagnosis.md from free-running tests with the 3 m Esso Osaka on the Inukai pond.
#   docs/results/make_esso_osaka_diagnosis.sh PROGRAM FOLDER_WITH_ESSO_OSAKA_RECORDINGS
# The measured wind is taken out of the recordings that the program sees, and laid beside what it found.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
program=$(realpath "$1") recordings=$(realpath "$2") ship=$here/../../ships/esso_osaka_3m.toml
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir "$work/tables"
cd "$work"
helper() { python3 "$here/diagnosis.py" "$@"; }

# run, begin and end [s]: propeller turning ahead and u above 0.08 m/s throughout
runs="turn_14-Sep-2020_13_39_32 16 360
turn_14-Sep-2020_13_51_45 15 405
turn_14-Sep-2020_14_16_04 15 330
turn_14-Sep-2020_14_50_41 21 223
turn_14-Sep-2020_15_47_33 45 216
turn_14-Sep-2020_15_58_08 13 430
turn_cut_14-Sep-2020_16_09_02 14 269
zigzag_31-Jul-2020_13_04_24 27 127
zigzag_31-Jul-2020_13_14_21 5 113
zigzag_31-Jul-2020_13_22_52 18 170
zigzag_31-Jul-2020_13_29_19 13 130
zigzag_31-Jul-2020_13_50_28 18 164
zigzag_31-Jul-2020_13_57_45 7 112
zigzag_31-Jul-2020_14_10_05 13 151"
found=()
while read -r run begin end; do
  helper prepare "$recordings/$run.csv" "$run.csv" --every 5 --from "$begin" --to "$end" --drop wind_speed_m_s,wind_from_rad
  helper wind "$recordings/$run.csv" --from "$begin" --to "$end" > "$run.wind.json"
  "$program" diagnose "$ship" "$run.csv" --json > "$run.json"
  # second route, without diagnosis: the wind of measured speed from 24 directions, replays compared
  speed=$(python3 -c 'import json, sys; print(json.load(open(sys.argv[1]))["wind_speed_m_s"])' "$run.wind.json")
  for ((from = 0; from < 360; from += 15)); do
    { cat "$ship"; printf '\n[[effect]]\nkind = "steady_wind"\nwind_speed_m_s = %s\nwind_from_rad = %s\n' "$speed" "$(python3 -c "import math; print(math.radians($from))")"; } > windy.toml
    "$program" compare windy.toml "$run.csv" --json > "$run.from_$from.json" 2> /dev/null
  done
  found+=("${run//_/ }=$run.json")
done <<< "$runs"

"$program" diagnose "$ship" zigzag_*.csv --json > zigzags.json
"$program" diagnose "$ship" turn_*.csv --json > turns.json
found_together=("seven zigzags of 31 July=zigzags.json" "seven turns of 14 September=turns.json")
helper found "${found_together[@]}" > tables/together.md
helper found "${found[@]}" > tables/found.md
helper winds "${found[@]}" > tables/winds.md
"$here/../papers/put_tables.sh" "$here/esso_osaka_diagnosis.md" "$work/tables"
