#!/usr/bin/env bash
# Makes the table of docs/effects.md from the files of the effects.
#   docs/effects/make_table.sh BUILD_FOLDER
# Needs the target effect_table.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
program=$(cd "$1" && pwd)/examples/effect_table
tables=$(mktemp -d)
trap 'rm -rf "$tables"' EXIT
"$program" "$tables"
"$here/../papers/put_tables.sh" "$here/../effects.md" "$tables"
