#!/bin/bash
# Builds swayaw by clang++, with warnings as errors, and runs all tests; fails when one of them fails.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")"

./setup.sh tests/packages.txt
status=0
cmake --workflow --preset test || status=$?
# tests that lack recordings, or a program, say so and pass
grep -h '^\[skipped\]' build/clang/Testing/Temporary/LastTest.log 2>/dev/null | sort -u || true
exit $status
