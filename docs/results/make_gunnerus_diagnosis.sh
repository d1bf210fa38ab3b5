#!/usr/bin/env bash
# Makes the tables of docs/results/gunnerus_diagnosis.md from the trials of R/V Gunnerus of 27 October 2022.
#   docs/results/make_gunnerus_diagnosis.sh BUILD_FOLDER FOLDER_WITH_GUNNERUS_RECORDINGS
# Needs the targets swayaw and gunnerus_ship.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
build=$(realpath "$1") recordings=$(realpath "$2")
program=$build/app/swayaw
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir "$work/tables"
cd "$work"
helper() { python3 "$here/diagnosis.py" "$@"; }

"$build/examples/gunnerus_ship" gunnerus.toml
# the order stands where the angle should: that is what is hidden
columns=ug_m_s:u_m_s,vg_m_s:v_m_s,delta_order_rad:delta_rad
for run in "$recordings"/*.csv; do helper prepare "$run" "$(basename "$run")" --rename "$columns" --drop phi_rad; done
for run in [0-9]*.csv; do helper prepare "$run" "trackless_$run" --drop x_m,y_m; done

"$program" diagnose gunnerus.toml trackless_{1550,1850,3250}_*.csv --holdout trackless_3700_*.csv trackless_4150_*.csv --report order.html --json > order.json
"$program" diagnose gunnerus.toml trackless_{1550,1850,3700}_*.csv --holdout trackless_3250_*.csv trackless_4150_*.csv --json > second.json
"$program" diagnose gunnerus.toml trackless_{1850,2550,4150}_*.csv --holdout trackless_1550_*.csv trackless_3250_*.csv --json > third.json
helper found "1550, 1850, 3250=order.json" "1550, 1850, 3700=second.json" "1850, 2550, 4150=third.json" > tables/choices.md
helper instruments "1550, 1850, 3250=order.json" "1550, 1850, 3700=second.json" "1850, 2550, 4150=third.json" > tables/instruments.md
"$program" diagnose gunnerus.toml 0350_*.csv 0800_*.csv 1100_*.csv --json > speed.json
"$program" diagnose gunnerus.toml [0-9]*.csv --json > all.json
helper found "zigzags, without positions=order.json" "two circles and a straight leg, with positions=speed.json" "all twelve runs, with positions=all.json" > tables/found.md
helper instruments "all twelve=all.json" > tables/day.md
helper candidates all.json 8 > tables/all.md
helper candidates order.json 8 > tables/order.md
helper candidates speed.json 8 > tables/speed.md
helper errors order.json > tables/errors.md
helper track "$recordings"/*.csv > tables/track.md
"$program" check "$recordings"/*.csv --json > check.json
helper scales check.json r > tables/scales.md
helper lag "$recordings"/*zigzag*.csv > tables/lag.md
helper picture order.html "$here/gunnerus.svg"
"$here/../papers/put_tables.sh" "$here/gunnerus_diagnosis.md" "$work/tables"
