#!/usr/bin/env bash
# Makes the tables of docs/captive_tests.md from the captive tests of HMRI (SIMMAN 2014).
#   docs/captive_tests/make_tables.sh BUILD_FOLDER FOLDER_WITH_HMRI_TESTS
# Needs the target captive_tables.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
program=$(cd "$1" && pwd)/examples/captive_tables
numbers=$(mktemp -d)
trap 'rm -rf "$numbers"' EXIT
"$program" "$here/../../ships" "$2" "$numbers"
"$here/../papers/put_tables.sh" "$here/../captive_tests.md" "$numbers"
