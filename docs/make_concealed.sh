#!/usr/bin/env bash
# Makes the tables of docs/concealed.md. Cases that are answered already are not diagnosed again, so it may be stopped and begun anew.
#   docs/make_concealed.sh BUILD_FOLDER FOLDER_FOR_CASES [JOBS] [CLEAN] [OTHERS]
# Needs the target swayaw_concealed. CLEAN and OTHERS are numbers of cases with nothing hidden and of all kinds, 200 each unless given.
set -euo pipefail
"$(dirname "${BASH_SOURCE[0]}")/make_concealed_page.sh" concealed.md clean all "$1" "$2" "${3:-1}" "${4:-200}" "${5:-200}"
