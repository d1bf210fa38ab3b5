#!/usr/bin/env bash
# Makes the tables of docs/results/kcs_diagnosis.md from MARIN's free-running tests with KCS (SIMMAN).
#   docs/results/make_kcs_diagnosis.sh PROGRAM FOLDER_WITH_KCS_RECORDINGS
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
program=$(realpath "$1") recordings=$(realpath "$2") ship=$here/../../ships/kcs.toml
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir "$work/tables"
cd "$work"
helper() { python3 "$here/diagnosis.py" "$@"; }

# positions and velocities of the source are those of the centre of gravity.
# 16.2 samples per second are 1.25: the ship needs 19 s for her own length, and one of her rolls takes 30 to 40 s
for run in "$recordings"/kcs_*.csv; do helper prepare "$run" "$(basename "$run")" --every 13 --drop p_rad_s --key "reference_x_m = -3.404"; done
for run in kcs_*.csv; do helper prepare "$run" "blind_$run" --drop phi_rad; done

"$program" diagnose "$ship" kcs_zigzag_port_10.csv kcs_zigzag_port_20.csv --holdout kcs_turning_port_35.csv --report seen.html --json > seen.json
"$program" diagnose "$ship" blind_kcs_zigzag_port_10.csv blind_kcs_zigzag_port_20.csv --holdout blind_kcs_turning_port_35.csv --json > blind.json

helper found "roll recorded=seen.json" "roll column taken out=blind.json" > tables/found.md
helper candidates seen.json 8 > tables/candidates.md
helper errors seen.json > tables/errors.md
helper roll "$recordings"/kcs_*.csv > tables/roll.md
helper picture seen.html "$here/kcs.svg"
"$here/../papers/put_tables.sh" "$here/kcs_diagnosis.md" "$work/tables"
