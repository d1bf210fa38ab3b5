#!/usr/bin/env bash
# Makes the table of docs/results/fleets.md: fleets by chance, some minutes on two cores.
#   docs/results/make_fleets.sh BUILD_FOLDER [SEED] [COUNT] [QUIET]
# Needs the target swayaw_fleets.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")"
seed=${2:-5000} count=${3:-12} quiet=${4:-12}
table=$("$1"/bench/concealed/swayaw_fleets --seed "$seed" --count "$count" --quiet "$quiet")
page=fleets.md
{
  sed '/^<!-- table -->$/q' "$page"
  printf '\nMade by `docs/results/make_fleets.sh build/release %s %s %s`.\n\n%s\n' "$seed" "$count" "$quiet" "$table"
} > "$page.draft"
mv "$page.draft" "$page"
