#!/bin/bash
# The same numbers from g++ and clang++: builds results.cpp and the library by both, optimised, and compares line by line.
#   tests/build/compilers.sh
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."

# Largest relative difference that is allowed.
limit=1e-12

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
for preset in dev clang; do
  cmake --preset $preset >/dev/null
  cmake --build --preset $preset --target swayaw_results
  build/$preset/tests/build/swayaw_results ships examples/recordings >"$work/$preset"
done
paste -d ' ' "$work/dev" "$work/clang" | awk -v limit=$limit '
  function size(x) { return x < 0 ? -x : x }
  $1 != $3 || NF != 4 { print "compilers: other numbers: " $0; failed = 1; next }
  {
    larger = size($2) > size($4) ? size($2) : size($4)
    apart = larger > 0 ? size($2 - $4) / larger : 0
    if ($2 == $4) same++
    if (apart > worst) { worst = apart; where = $1 }
    if (apart > limit) { printf "compilers: %s is %s by g++ and %s by clang++, %.1e apart\n", $1, $2, $4, apart; failed = 1 }
  }
  END {
    printf "compilers: %d numbers by g++ and clang++, %d the same to the last bit, at most %.1e apart (%s)\n", NR, same, worst, where
    exit failed || NR == 0
  }'
