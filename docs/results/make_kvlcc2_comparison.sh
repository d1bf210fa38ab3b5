#!/usr/bin/env bash
# Makes the tables of docs/results/kvlcc2_comparison.md from the SIMMAN 2008 recordings.
#   docs/results/make_kvlcc2_comparison.sh PROGRAM FOLDER_WITH_RECORDINGS
set -euo pipefail
program=$(realpath "$1") recordings=$(realpath "$2")
cd "$(dirname "$0")"
ship=../../ships/kvlcc2_l7.toml
tables() { "$program" compare "$ship" "$recordings"/*.csv --shaft "$1" --markdown 2>/dev/null; }
{
  sed '/^<!-- tables -->$/q' kvlcc2_comparison.md
  printf '\n## At the recorded shaft speed\n\n'
  tables recorded
  printf '\n## At the self-propulsion point of the model\n\n'
  tables self-propulsion
} > kvlcc2_comparison.md.new
mv kvlcc2_comparison.md.new kvlcc2_comparison.md
