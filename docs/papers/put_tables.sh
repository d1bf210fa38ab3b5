#!/usr/bin/env bash
# Puts computed tables into a page: each one between <!-- table: NAME --> and <!-- end --> is replaced by FOLDER/NAME.md, and
# stays as it is where there is no such file.
#   docs/papers/put_tables.sh PAGE FOLDER
set -euo pipefail
awk -v folder="$2" '
  /^<!-- end -->$/ { inside = 0 }
  !inside { print }
  /^<!-- table: .* -->$/ {
    file = folder "/" $3 ".md"
    inside = (got = getline line < file) >= 0
    for (; got > 0; got = getline line < file) print line
    close(file)
  }' "$1" > "$1.new"
mv "$1.new" "$1"
