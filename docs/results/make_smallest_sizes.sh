#!/usr/bin/env bash
# Makes the table of docs/results/smallest_sizes.md: plants effects at the sizes that are listed as the smallest to show.
#   docs/results/make_smallest_sizes.sh BUILD_FOLDER
# Needs the target smallest_sizes_table; takes a quarter of an hour.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
tables=$(mktemp -d)
trap 'rm -rf "$tables"' EXIT
"$1/tests/mismatch/smallest_sizes_table" > "$tables/smallest.md"
"$here/../papers/put_tables.sh" "$here/smallest_sizes.md" "$tables"
