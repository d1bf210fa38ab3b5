#!/bin/bash
# Each command has a page of the manual, which has every option that the completion knows of, and roff that nobody complains of.
#   manual.sh PROGRAM PYTHON SCRATCH
set -euo pipefail
program=$1 python=$2 pages=$3
rm -rf "$pages"
"$python" "$(dirname "${BASH_SOURCE[0]}")/../../packaging/make_man.py" "$program" "$pages" --date 2026-01-31 --compress

"$program" completion | sed -nE 's/^ +([a-z]+)\) words="(.*)" ;;$/\1 \2/p' >"$pages/options"
while read -r command options; do
  page=$pages/swayaw-$command.1
  for option in $options; do
    # as roff writes it
    grep -qF -- "${option//-/\\-}" "$page" || { echo "manual: $page lacks $option" >&2; exit 1; }
  done
  grep -qF "swayaw\\-$command" "$pages/swayaw.1" || { echo "manual: swayaw.1 lacks $command" >&2; exit 1; }
done <"$pages/options"
test "$(wc -l <"$pages/options")" -gt 10

command -v mandoc >/dev/null || { echo "[skipped] consumer.manual: no mandoc"; exit 77; }
said=$(mandoc -T lint -W warning "$pages"/*.1) || { echo "$said" >&2; exit 1; }
