#!/usr/bin/env bash
# Makes the tables of docs/results/on_board_cases.md from labelled cases with instruments as on board and their score.
#   docs/results/make_on_board_cases.sh PROGRAM SCORE FOLDER_WITH_CASES [SCORES.json]
# Arguments: see make_labelled_page.sh.
set -euo pipefail
"$(dirname "${BASH_SOURCE[0]}")/make_labelled_page.sh" on_board_cases.md 0 "$@"
