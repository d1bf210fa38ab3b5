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
while read -r run begin end; do
  helper prepare "$recordings/$run.csv" "$run.csv" --from "$begin" --to "$end" --drop wind_speed_m_s,wind_from_rad
  helper wind "$recordings/$run.csv" --from "$begin" --to "$end" > "$run.wind.json"
done < "$here/esso_osaka_runs.txt"

"$program" diagnose "$ship" turn_*.csv --report turns.html --json > turns.json
"$program" diagnose "$ship" zigzag_*.csv --json > zigzags.json
# every other turn is held out
"$program" diagnose "$ship" turn_14-Sep-2020_1{3_39,4_16,5_47}_*.csv turn_cut_*.csv --holdout turn_14-Sep-2020_1{3_51,4_50,5_58}_*.csv --json > held_out.json
helper surroundings turns.json zigzags.json > tables/winds.md
helper budget "turns=turns.json" "zigzags=zigzags.json" > tables/budget.md
helper found "seven turns of 14 September=turns.json" "seven zigzags of 31 July=zigzags.json" "four of the turns=held_out.json" > tables/found.md
helper candidates turns.json 8 > tables/candidates.md
helper errors held_out.json > tables/errors.md
helper picture turns.html "$here/esso_osaka.svg"
"$here/../papers/put_tables.sh" "$here/esso_osaka_diagnosis.md" "$work/tables"
