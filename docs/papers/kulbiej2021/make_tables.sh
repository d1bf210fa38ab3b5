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

# each table between <!-- table: NAME --> and <!-- end --> is replaced by the computed one
page=$here/../kulbiej2021.md
awk -v folder="$numbers" '
  /^<!-- end -->$/ { inside = 0 }
  !inside { print }
  /^<!-- table: .* -->$/ {
    inside = 1
    file = folder "/" $3 ".md"
    while ((getline line < file) > 0) print line
    close(file)
  }' "$page" > "$page.new"
mv "$page.new" "$page"
