#!/usr/bin/env bash
# Makes the tables of docs/results/on_board_cases.md from labelled cases with instruments as on board and their score.
#   docs/results/make_on_board_cases.sh PROGRAM SCORE FOLDER_WITH_CASES [SCORES.json]
# SCORE PROGRAM CASES --json OUT runs `diagnose` on every case and compares with its label; SCORES.json is such an OUT that is there already.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
program=$(realpath "$1") score=$(realpath "$2") cases=$(realpath "$3")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir "$work/tables"
if [ $# -gt 3 ]; then
  cp "$4" "$work/scores.json"
else
  "$score" "$program" "$cases" --timeout 600 --json "$work/scores.json" > /dev/null
fi
python3 "$here/labelled_cases.py" "$work/tables" "$work/scores.json"
"$here/../papers/put_tables.sh" "$here/on_board_cases.md" "$work/tables"
