#!/usr/bin/env bash
# Makes the tables and figures of docs/papers/kulbiej2021.md from the JSON and the time series of the program.
#   docs/papers/kulbiej2021/make_tables.sh BUILD_FOLDER
# Needs the target swayaw and Debian's python3-matplotlib.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
program=$(cd "$1" && pwd)/app/swayaw
numbers=$(mktemp -d)
trap 'rm -rf "$numbers"' EXIT
/usr/bin/python3 "$here/compute.py" "$program" "$here/../../.." "$numbers" "$here"
"$here/../put_tables.sh" "$here/../kulbiej2021.md" "$numbers"
