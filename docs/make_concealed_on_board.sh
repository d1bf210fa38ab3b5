#!/usr/bin/env bash
# Makes the tables of docs/concealed_on_board.md. Cases that are answered already are not diagnosed again, so it may be stopped and begun anew;
# with CLEAN and OTHERS it makes that many cases with nothing hidden and with something, 10 and 30 unless given.
#   docs/make_concealed_on_board.sh BUILD_FOLDER FOLDER_FOR_CASES [JOBS] [CLEAN] [OTHERS]
# Needs the target swayaw_concealed. A diagnosis takes 10 to 60 s of one core.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
program=$(cd "$1" && pwd)/bench/concealed/swayaw_concealed
cases=$2 jobs=${3:-1} clean=${4:-10} others=${5:-30}
made() { [ -e "$cases/$1/$(printf %03d "$2")/truth.json" ] || "$program" make "$cases/$1" --plan "$1" --count "$2" --seed "$3" --jobs "$jobs"; }
made on_board_clean "$clean" 1
made on_board "$others" 2
"$program" score "$cases/on_board_clean" --jobs "$jobs"
"$program" score "$cases/on_board" --jobs "$jobs"
"$program" tables "$cases/tables" "$cases/on_board_clean/score.jsonl" "$cases/on_board/score.jsonl"
"$here/papers/put_tables.sh" "$here/concealed_on_board.md" "$cases/tables"
