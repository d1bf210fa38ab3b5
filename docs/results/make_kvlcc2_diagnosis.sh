#!/usr/bin/env bash
# Makes the tables of docs/results/kvlcc2_diagnosis.md from the SIMMAN 2008 recordings of HSVA and MARIN.
#   docs/results/make_kvlcc2_diagnosis.sh PROGRAM FOLDER_WITH_KVLCC2_RECORDINGS
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
program=$(realpath "$1") recordings=$(realpath "$2") ships=$here/../../ships
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir "$work/tables"
cd "$work"
helper() { python3 "$here/diagnosis.py" "$@"; }

# 20 and 10 samples per second are made 4 and 5: the ship needs 6 s for her own length, and neighbouring samples of smoothed channels tell the same thing twice
for run in "$recordings"/hsva_*.csv; do helper prepare "$run" "$(basename "$run")" --every 5; done
for run in "$recordings"/marin_*.csv; do helper prepare "$run" "$(basename "$run")" --every 2; done
# the published limits of the wake change contradict each other (0.55 and 1.1 on one side), so they are open here
{ cat "$ships/kvlcc2_pi_vvr.toml"; printf '\n[confidence]\ncoefficients = 0.1\nwake_C1 = 0.3\nwake_C2_positive = 0.5\nwake_C2_negative = 1.0\n'; } > open_wake.toml

four=(hsva_zz10_10_port.csv hsva_zz10_10_stbd.csv hsva_zz20_10_port.csv hsva_zz20_10_stbd.csv)
others=(hsva_zz15_05_stbd.csv hsva_zz10_01_stbd.csv hsva_zz30_05_stbd.csv)
"$program" diagnose "$ships/kvlcc2_pi.toml" "${four[@]}" --holdout "${others[@]}" --report hull.html --json > hull.json
"$program" diagnose open_wake.toml "${four[@]}" --holdout "${others[@]}" --save-model wake.toml --json > wake.json
"$program" diagnose "$ships/kvlcc2_pi_vvr.toml" marin_*.csv --reference "${four[@]}" --json > gyro.json
for run in marin_zz10_10_port marin_zz20_20_stbd; do "$program" diagnose "$ships/kvlcc2_pi_vvr.toml" "$run.csv" --json > "$run.json"; done

helper found "published form=hull.json" "with v'²r', wake open=wake.json" > tables/found.md
helper candidates hull.json 8 > tables/hull.md
helper errors hull.json > tables/hull_errors.md
helper numbers open_wake.toml wake.toml wake_C1 wake_C2_positive wake_C2_negative > tables/wake.md
helper errors wake.json > tables/wake_errors.md
helper found "both, four HSVA runs as reference=gyro.json" "10/10 alone=marin_zz10_10_port.json" "20/20 alone=marin_zz20_20_stbd.json" > tables/gyro.md
helper instruments "both, four HSVA runs as reference=gyro.json" "10/10 alone=marin_zz10_10_port.json" "20/20 alone=marin_zz20_20_stbd.json" > tables/instruments.md
helper zeros marin_zz10_10_port.csv marin_zz20_20_stbd.csv > tables/zeros.md
helper picture hull.html "$here/kvlcc2.svg"
"$here/../papers/put_tables.sh" "$here/kvlcc2_diagnosis.md" "$work/tables"
