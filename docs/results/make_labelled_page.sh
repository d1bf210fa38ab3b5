#!/usr/bin/env bash
# Scores labelled cases and puts the tables into a page: what make_open_cases.sh and make_on_board_cases.sh do.
#   docs/results/make_labelled_page.sh PAGE ERROR PROGRAM SCORE FOLDER_WITH_CASES [SCORES.json [WRONG_SCORES.json]]
# SCORE PROGRAM CASES --json OUT runs `diagnose` on every case and compares with its label; SCORES.json is such an OUT that is there already.
# ERROR above 0: a second score of the same cases with ship files that are wrong by that share, WRONG_SCORES.json if it is there already.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
page=$1 error=$2 program=$(realpath "$3") score=$(realpath "$4") cases=$(realpath "$5")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir "$work/tables"
scores() { [ -n "$2" ] && realpath "$2" || { "$score" "$program" "$1" --timeout 600 --json "$3" > /dev/null; echo "$3"; }; }
tabled=("$(scores "$cases" "${6:-}" "$work/scores.json")")
if [ "$error" != 0 ]; then
  [ -n "${7:-}" ] || python3 "$here/wrong_ship_files.py" "$cases" "$work/wrong" "$error" 1
  tabled+=("$(scores "$work/wrong" "${7:-}" "$work/wrong.json")")
fi
python3 "$here/labelled_cases.py" "$work/tables" "${tabled[@]}"
"$here/../papers/put_tables.sh" "$here/$page" "$work/tables"
