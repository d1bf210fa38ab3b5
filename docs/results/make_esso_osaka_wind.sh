#!/usr/bin/env bash
# Makes the tables of docs/results/esso_osaka_wind.md from free-running tests with the 3 m Esso Osaka on the Inukai pond.
#   docs/results/make_esso_osaka_wind.sh PROGRAM FOLDER_WITH_ESSO_OSAKA_RECORDINGS
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
program=$(realpath "$1") recordings=$(realpath "$2") ship=$here/../../ships/esso_osaka_3m.toml
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir "$work/tables"
cd "$work"

# replays of the ship as published, with the measured wind and as if it had not been measured
turns=("$recordings"/turn_*.csv) zigzags=("$recordings"/zigzag_*.csv)
"$program" compare "$ship" "${turns[@]}" "${zigzags[@]}" --no-check --json > with.json
"$program" compare "$ship" "${turns[@]}" "${zigzags[@]}" --no-check --ignore-wind --json > without.json
python3 "$here/esso_osaka_wind.py" compared with.json without.json > tables/compared.md

# coefficients from three turns and four zigzags, the other turns held out
used=("${turns[@]:0:2}" "${turns[3]}" "${zigzags[@]:0:4}") held=("${turns[2]}" "${turns[@]:4}")
for how in with without; do
  ignore=()
  [[ $how == with ]] || ignore=(--ignore-wind)
  "$program" identify "${used[@]}" --ship "$ship" --model mmg --fit forces --prior --no-check --out "$how.toml" "${ignore[@]}" > /dev/null
  "$program" compare "$how.toml" "${held[@]}" --no-check "${ignore[@]}" --json > "$how.held.json"
done
python3 "$here/esso_osaka_wind.py" compared with.held.json without.held.json > tables/held.md

# what one turn is said to lack
"$program" diagnose "$ship" "$recordings/turn_14-Sep-2020_15_47_33.csv" --json > with.diagnosis.json
"$program" diagnose "$ship" "$recordings/turn_14-Sep-2020_15_47_33.csv" --ignore-wind --json > without.diagnosis.json
python3 "$here/esso_osaka_wind.py" diagnosed with.diagnosis.json without.diagnosis.json > tables/diagnosed.md
"$here/../papers/put_tables.sh" "$here/esso_osaka_wind.md" "$work/tables"
