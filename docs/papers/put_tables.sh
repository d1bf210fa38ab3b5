#!/usr/bin/env bash
# Puts computed tables into a page: each one between <!-- table: NAME --> and <!-- end --> is replaced by FOLDER/NAME.md.
#   docs/papers/put_tables.sh PAGE FOLDER
set -euo pipefail
awk -v folder="$2" '
  /^<!-- end -->$/ { inside = 0 }
  !inside { print }
  /^<!-- table: .* -->$/ {
    inside = 1
    file = folder "/" $3 ".md"
    while ((getline line < file) > 0) print line
    close(file)
  }' "$1" > "$1.new"
mv "$1.new" "$1"
