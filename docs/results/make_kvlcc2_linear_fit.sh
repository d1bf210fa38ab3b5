#!/usr/bin/env bash
# Makes the table of docs/linear_identification.md from the SIMMAN 2008 recordings.
#   docs/results/make_kvlcc2_linear_fit.sh EXAMPLE_PROGRAM FOLDER_WITH_RECORDINGS
set -euo pipefail
program=$(realpath "$1") recordings=$(realpath "$2")
cd "$(dirname "$0")/.."
{
  sed '/^<!-- table -->$/q' linear_identification.md
  printf '\n'
  "$program" --table 7.0 "$recordings"/*.csv
} > linear_identification.md.new
mv linear_identification.md.new linear_identification.md
