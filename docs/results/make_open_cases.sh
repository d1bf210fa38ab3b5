#!/usr/bin/env bash
# Makes the tables of docs/results/open_cases.md from labelled cases and their score, once more with ship files that are wrong by 3 %.
#   docs/results/make_open_cases.sh PROGRAM SCORE FOLDER_WITH_CASES [SCORES.json WRONG_SCORES.json]
# Arguments: see make_labelled_page.sh.
set -euo pipefail
"$(dirname "${BASH_SOURCE[0]}")/make_labelled_page.sh" open_cases.md 0.03 "$@"
