#!/usr/bin/env bash
# Makes the tables of docs/results/open_cases.md from labelled cases and their score.
#   docs/results/make_open_cases.sh PROGRAM SCORE FOLDER_WITH_CASES [SCORES.json WRONG_SCORES.json]
# SCORE PROGRAM CASES --json OUT runs `diagnose` on every case and compares with its label; SCORES.json is such an OUT that is there already, WRONG_SCORES.json
# one of the same cases with ship files that are wrong by 3 %.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
program=$(realpath "$1") score=$(realpath "$2") cases=$(realpath "$3")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir "$work/tables"
if [ $# -gt 4 ]; then
  cp "$4" "$work/scores.json"
  cp "$5" "$work/wrong.json"
else
  python3 "$here/wrong_ship_files.py" "$cases" "$work/wrong" 0.03 1
  "$score" "$program" "$cases" --json "$work/scores.json" > /dev/null
  "$score" "$program" "$work/wrong" --json "$work/wrong.json" > /dev/null
fi
python3 "$here/labelled_cases.py" "$work/tables" "$work/scores.json" "$work/wrong.json"
"$here/../papers/put_tables.sh" "$here/open_cases.md" "$work/tables"
