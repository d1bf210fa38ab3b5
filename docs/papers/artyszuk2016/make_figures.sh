#!/usr/bin/env bash
# Makes the figures and the tables of docs/papers/artyszuk2016.md.
#   docs/papers/artyszuk2016/make_figures.sh BUILD_FOLDER
# Needs the targets example_linear_figures and artyszuk2016_tables, and Debian's python3-matplotlib.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
programs=$(cd "$1" && pwd)/examples
numbers=$(mktemp -d)
trap 'rm -rf "$numbers"' EXIT
"$programs/example_linear_figures" "$numbers"
"$programs/artyszuk2016_tables" "$here/../../../tests/golden/artyszuk_linear.json" "$numbers"
/usr/bin/python3 "$here/draw.py" "$numbers" "$here"
"$here/../put_tables.sh" "$here/../artyszuk2016.md" "$numbers"
