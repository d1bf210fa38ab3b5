#!/usr/bin/env bash
# Makes the tables of docs/captive_tests.md from the captive tests of HMRI (SIMMAN 2014).
#   docs/captive_tests/make_tables.sh BUILD_FOLDER FOLDER_WITH_HMRI_TESTS
# Needs the target captive_tables.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
program=$(cd "$1" && pwd)/examples/captive_tables
numbers=$(mktemp -d)
trap 'rm -rf "$numbers"' EXIT
"$program" "$here/../../ships" "$2" "$numbers"

# the power of the frequency with which X goes at twice the frequency, from the slowest to the fastest test in pure yaw
awk -F, 'NR == 1 { for (i = 1; i <= NF; i++) place[$i] = i; next }
  NR == 2 { x = $place["X_in2_prime"]; f = $place["rdot_prime_amp"] / $place["r_prime_amp"] }
  END { printf "From the slowest to the fastest of these tests it grows with the power %.1f of the frequency.\n", log($place["X_in2_prime"] / x) / log($place["rdot_prime_amp"] / $place["r_prime_amp"] / f) }' \
  "$2/hmri_pure_yaw.csv" > "$numbers/power.md"
"$here/../papers/put_tables.sh" "$here/../captive_tests.md" "$numbers"
