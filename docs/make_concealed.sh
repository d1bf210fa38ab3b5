#!/usr/bin/env bash
# Makes the tables of docs/concealed.md. Cases that are answered already are not diagnosed again, so it may be stopped and begun anew.
#   docs/make_concealed.sh BUILD_FOLDER FOLDER_FOR_CASES [JOBS] [CLEAN] [OTHERS]
# Needs the target swayaw_concealed. CLEAN and OTHERS are numbers of cases with nothing hidden and of all kinds, 200 each unless given.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
program=$(cd "$1" && pwd)/bench/concealed/swayaw_concealed
cases=$2 jobs=${3:-1} clean=${4:-200} others=${5:-200}
made() { [ -e "$cases/$1/$(printf %03d "$2")/truth.json" ] || "$program" make "$cases/$1" --plan "$1" --count "$2" --seed "$3" --jobs "$jobs"; }
made clean "$clean" 1
made all "$others" 2
"$program" score "$cases/clean" --jobs "$jobs"
"$program" score "$cases/all" --jobs "$jobs"
"$program" tables "$cases/tables" "$cases/clean/score.jsonl" "$cases/all/score.jsonl"
"$here/papers/put_tables.sh" "$here/concealed.md" "$cases/tables"
