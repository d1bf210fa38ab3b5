#!/bin/bash
# What takes longer than the other checks:
#
#   FLOOR…  tests of these floors under the address and undefined-behaviour sanitizers, by clang++, but for those that
#           take minutes like that
#   once    all of the library in one link by g++, where no class may be defined in two ways; a consumer without npm,
#           network and optional libraries
#   turn    one of these; which one, the time of the last commit decides. CI does this
#
#   tests/build/in_depth.sh core linear nonlinear | once | turn
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."

# Beyond 20 s of processor time optimised: three to ten minutes with sanitizers.
long='identification\.(data_compatibility|trial.*|trajectory_.*|linear_fit.*|identify)|mismatch\.(on_board|invariance|diagnose|recordings_diagnosis)'

sanitized() {
  cmake --preset sanitize >/dev/null
  cmake --build --preset sanitize --target "${@/#/swayaw_test_}"
  ctest --preset sanitize -R "^($(IFS='|'; echo "$*"))\." -E "^($long)$" --no-tests=error
}

once() {
  cmake --workflow --preset lto-odr
  tests/consumer/alone.sh || (($? == 77))
}

# Five parts, so that each landing waits five minutes for one and not half an hour for all.
turn() {
  local parts=("core linear" "nonlinear" "identification" "mismatch" "once")
  local part=${parts[$(($(git log -1 --format=%ct) % ${#parts[@]}))]}
  echo "in depth: $part"
  part $part
}

part() {
  case ${1:-} in
    core | linear | nonlinear | identification | mismatch) sanitized "$@" ;;
    once) once ;;
    turn) turn ;;
    *) echo "usage: in_depth.sh FLOOR... | once | turn" >&2; exit 2 ;;
  esac
}

part "$@"
