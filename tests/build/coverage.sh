#!/bin/bash
# Lines and branches of the floors that their tests run, into docs/coverage.md; fails where core, linear or nonlinear has
# less than 95 % of its lines or 85 % of its branches run.
#   tests/build/coverage.sh [--check] [FLOOR…]     by default core linear nonlinear; --check leaves the page as it is
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."

# What is asked of the floors that all others stand on [%].
lines=95 branches=85 held=(core linear nonlinear)

check=
if [[ ${1:-} == --check ]]; then check=yes; shift; fi
floors=("$@")
((${#floors[@]})) || floors=("${held[@]}")
build=$PWD/build/coverage

./setup.sh tests/build/coverage_packages.txt
cmake --preset coverage >/dev/null
cmake --build --preset coverage --target "${floors[@]/#/swayaw_test_}"

# One process runs all tests of a floor: its counts are one file.
mkdir -p "$build/profiles"
for floor in "${floors[@]}"; do
  (cd "$build" && LLVM_PROFILE_FILE=profiles/$floor.profraw "tests/$floor/swayaw_test_$floor" | tail -n 3)
done

asked=()
for floor in "${floors[@]}"; do [[ " ${held[*]} " != *" $floor "* ]] || asked+=("$floor"); done
tables=$(mktemp -d)
trap 'rm -rf "$tables"' EXIT
tests/build/coverage_table.py "$build" "${floors[@]}" --tables "$tables" --lines $lines --branches $branches \
  --of "$(IFS=,; echo "${asked[*]}")"
[[ $check ]] || docs/papers/put_tables.sh docs/coverage.md "$tables"
