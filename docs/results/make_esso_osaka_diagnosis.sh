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

# run, begin and end [s]: propeller turning ahead and u above 0.08 m/s throughout; the day of a run is its group
while read -r run begin end; do
  day=$(grep -o '[0-9]*-[A-Z][a-z]*-[0-9]*' <<< "$run")
  helper prepare "$recordings/$run.csv" "$run.csv" --from "$begin" --to "$end" --drop wind_speed_m_s,wind_from_rad --key "group = \"$day\""
  helper wind "$recordings/$run.csv" --from "$begin" --to "$end" > "$run.wind.json"
done < "$here/esso_osaka_runs.txt"

"$program" diagnose "$ship" turn_*.csv zigzag_*.csv --report both.html --json > both.json
"$program" diagnose "$ship" turn_*.csv --json > turns.json
"$program" diagnose "$ship" zigzag_*.csv --json > zigzags.json
# every other run of each day is held out
runs=(turn_*.csv zigzag_*.csv) used=() held=()
for i in "${!runs[@]}"; do if ((i % 2)); then held+=("${runs[i]}"); else used+=("${runs[i]}"); fi; done
"$program" diagnose "$ship" "${used[@]}" --holdout "${held[@]}" --json > held_out.json
# each run by itself
alone=()
for run in "${runs[@]}"; do
  "$program" diagnose "$ship" "$run" --json > "${run%.csv}.alone.json"
  alone+=("${run%.csv}=${run%.csv}.alone.json")
done
helper surroundings "${alone[@]}" > tables/alone.md
helper surroundings "both days=both.json" "turns=turns.json" "zigzags=zigzags.json" "every other run of both=held_out.json" > tables/winds.md
helper budget "both days=both.json" "turns=turns.json" "zigzags=zigzags.json" > tables/budget.md
helper found "both days=both.json" "seven turns of 14 September=turns.json" "seven zigzags of 31 July=zigzags.json" "every other run of both days=held_out.json" > tables/found.md
helper candidates both.json 8 > tables/candidates.md
helper errors held_out.json > tables/errors.md
helper picture both.html "$here/esso_osaka.svg"
"$here/../papers/put_tables.sh" "$here/esso_osaka_diagnosis.md" "$work/tables"
