#!/usr/bin/env bash
# Makes the tables of docs/results/kvlcc2_identification.md from the recordings of SIMMAN 2008 and the captive tests of HMRI.
#   docs/results/make_kvlcc2_identification.sh BUILD_FOLDER FOLDER_WITH_KVLCC2_RECORDINGS
# Needs the target kvlcc2_identification.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
program=$(cd "$1" && pwd)/examples/kvlcc2_identification
tables=$(mktemp -d)
trap 'rm -rf "$tables"' EXIT
"$program" "$here/../../ships" "$2" "$tables"
"$here/../papers/put_tables.sh" "$here/kvlcc2_identification.md" "$tables"
