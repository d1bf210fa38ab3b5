#!/usr/bin/env bash
# Makes the tables of docs/concealed_on_board.md. Cases that are answered already are not diagnosed again, so it may be stopped and begun anew.
#   docs/make_concealed_on_board.sh BUILD_FOLDER FOLDER_FOR_CASES [JOBS] [CLEAN] [OTHERS]
# Needs the target swayaw_concealed; the cases are those of seed 54. CLEAN and OTHERS are numbers of cases with nothing hidden and with something, 150 and 300 unless given. A diagnosis takes 5 to 80 s of one core.
set -euo pipefail
"$(dirname "${BASH_SOURCE[0]}")/make_concealed_page.sh" concealed_on_board.md on_board_clean on_board "$1" "$2" "${3:-1}" "${4:-150}" "${5:-300}" 54 54
