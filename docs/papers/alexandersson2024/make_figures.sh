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

# each table between <!-- table: NAME --> and <!-- end --> is replaced by the computed one
page=$here/../alexandersson2024.md
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
