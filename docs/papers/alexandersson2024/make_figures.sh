#!/usr/bin/env bash
# Makes the figures and the tables of docs/papers/alexandersson2024.md with the program.
#   docs/papers/alexandersson2024/make_figures.sh BUILD_FOLDER
# Needs the target swayaw and Debian's python3-matplotlib.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
program=$(cd "$1" && pwd)/app/swayaw
numbers=$(mktemp -d)
trap 'rm -rf "$numbers"' EXIT
/usr/bin/python3 "$here/tables.py" "$program" "$here/../../.." "$numbers"
/usr/bin/python3 "$here/draw.py" "$numbers/curves.json" "$here"
"$here/../put_tables.sh" "$here/../alexandersson2024.md" "$numbers"
