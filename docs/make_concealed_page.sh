#!/usr/bin/env bash
# Makes cases by two plans, one with nothing hidden, diagnoses them and puts the tables into a page: what make_concealed.sh and make_concealed_on_board.sh do.
# Cases that are answered already are not diagnosed again, so it may be stopped and begun anew.
#   docs/make_concealed_page.sh PAGE CLEAN_PLAN OTHER_PLAN BUILD_FOLDER FOLDER_FOR_CASES JOBS CLEAN OTHERS [CLEAN_SEED OTHER_SEED]
# Needs the target swayaw_concealed. CLEAN and OTHERS are numbers of cases; seeds are 1 and 2 unless given.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
page=$1 clean_plan=$2 other_plan=$3 program=$(cd "$4" && pwd)/bench/concealed/swayaw_concealed cases=$5 jobs=$6 clean=$7 others=$8 clean_seed=${9:-1} other_seed=${10:-2}
made() { [ -e "$cases/$1/$(printf %03d "$2")/truth.json" ] || "$program" make "$cases/$1" --plan "$1" --count "$2" --seed "$3" --jobs "$jobs"; }
made "$clean_plan" "$clean" "$clean_seed"
made "$other_plan" "$others" "$other_seed"
"$program" score "$cases/$clean_plan" --jobs "$jobs"
"$program" score "$cases/$other_plan" --jobs "$jobs"
"$program" tables "$cases/tables" "$cases/$clean_plan/score.jsonl" "$cases/$other_plan/score.jsonl"
"$here/papers/put_tables.sh" "$here/$page" "$cases/tables"
