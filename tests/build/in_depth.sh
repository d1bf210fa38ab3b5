#!/bin/bash
# What takes longer than the other checks, in three parts; CI does the first:
#
#   lower   tests of core, linear and nonlinear under the address and undefined-behaviour sanitizers, by clang++
#   upper   the same of identification and mismatch, but for those that take minutes like that
#   once    all of the library in one link by g++, where no class may be defined in two ways; a consumer without npm,
#           network and optional libraries
#
#   tests/build/in_depth.sh lower|upper|once
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."

# Beyond 20 s of processor time optimised: three to ten minutes with sanitizers.
long='identification\.(data_compatibility|trial.*|trajectory_.*|linear_fit.*|identify)|mismatch\.(on_board|invariance|diagnose|recordings_diagnosis)'

sanitized() {
  cmake --preset sanitize >/dev/null
  cmake --build --preset sanitize --target "${@/#/swayaw_test_}"
  ctest --preset sanitize -R "^($(IFS='|'; echo "$*"))\." -E "^($long)$" --no-tests=error
}

case ${1:-} in
  lower) sanitized core linear nonlinear ;;
  upper) sanitized identification mismatch ;;
  once)
    cmake --workflow --preset lto-odr
    tests/consumer/alone.sh || (($? == 77))
    ;;
  *) echo "usage: in_depth.sh lower|upper|once" >&2; exit 2 ;;
esac
