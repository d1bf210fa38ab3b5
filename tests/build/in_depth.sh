#!/bin/bash
# What takes longer than the other checks, in parts; each builds what it needs:
#
#   gcc FLOOR…        tests of these floors by g++, which users compile with
#   addresses FLOOR…  tests of these floors under the address and undefined-behaviour sanitizers, by clang++
#   longest FLOOR…    the same of those tests that take long, which all other parts leave out
#   threads FLOOR…    tests of what works on several threads, under the thread sanitizer
#   coverage          lines and branches that the tests of core, linear and nonlinear run, against what is asked of them
#   compilers         the same numbers from g++ and clang++
#   once              all of the library in one link by g++, where no class may be defined in two ways; a consumer without
#                     npm, network and optional libraries
#   turn [SECONDS]    one of these; which one, the time of the last commit decides, among those that take no longer. CI
#                     does this
#   parts             the list of parts, with their times
#
#   tests/build/in_depth.sh addresses core linear | threads mismatch | … | turn 300
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."

# Seconds on two processors that have nothing else to do, from a clean clone, and the part. The longest tests, 12 minutes of
# app and an hour of identification and mismatch, are not among them.
parts=(
  "110 threads core linear"
  "120 addresses core"
  "150 gcc core linear"
  "170 addresses linear"
  "270 gcc nonlinear"
  "300 coverage"
  "300 threads nonlinear sweep"
  "330 compilers"
  "330 once"
  "450 addresses nonlinear"
  "480 threads mismatch"
  "500 gcc identification"
  "540 addresses identification"
  "540 addresses mismatch"
  "600 gcc mismatch"
  "800 addresses app sweep"
)

# Beyond 20 s of processor time optimised: three to ten minutes with sanitizers.
long='identification\.(data_compatibility|trial.*|trajectory_.*|linear_fit.*|identify)|mismatch\.(on_board|invariance|diagnose|recordings_diagnosis)|app\.(demo|documentation|diagnose_report|pages)'

# Of these floors only what works on several threads; of the others everything.
threaded='(core|linear|mismatch)\..*|nonlinear\.(batch|estimate_spread|index_slopes)|sweep\.(plan|points|reduce|run)'

#   floors_tested PRESET TESTS but|only FLOOR…    but for the longest tests, or those only
floors_tested() {
  local preset=$1 tests=$2 which=$3 floors
  shift 3
  floors="^($(IFS='|'; echo "$*"))\."
  cmake --preset "$preset" >/dev/null
  local targets=("${@/#/swayaw_test_}")
  [[ " $* " != *" app "* ]] || targets+=(swayaw_report_test)
  [[ " $* " != *" sweep "* ]] || targets+=(swayaw)
  cmake --build --preset "$preset" --target "${targets[@]}"
  local names
  names=$(ctest --preset "$preset" -N -R "$floors" | sed -nE 's/^ *Test +#[0-9]+: //p' | grep -xE "$tests" |
    if [[ $which == only ]]; then grep -xE "$long"; else grep -vxE "$long"; fi | paste -sd '|') || true
  ctest --preset "$preset" -R "^(${names//./\\.})$" --no-tests=error
}

once() {
  cmake --workflow --preset lto-odr
  tests/consumer/alone.sh || (($? == 77))
}

# Of the parts that take no longer than the seconds that are given, the one whose turn it is.
turn() {
  local seconds=${1:-3600} fitting=() each
  for each in "${parts[@]}"; do ((${each%% *} > seconds)) || fitting+=("$each"); done
  ((${#fitting[@]})) || { echo "in depth: left out, every part takes more than the $seconds s that are left"; return; }
  each=${fitting[$(($(git log -1 --format=%ct) % ${#fitting[@]}))]}
  echo "in depth: ${each#* }, about ${each%% *} of the $seconds s that are left"
  part ${each#* }
}

part() {
  local kind=${1:-}
  case $kind in
    addresses) floors_tested sanitize '.*' but "${@:2}" ;;
    longest) floors_tested sanitize '.*' only "${@:2}" ;;
    threads) floors_tested tsan "$threaded" but "${@:2}" ;;
    coverage) tests/build/coverage.sh --check ;;
    compilers) tests/build/compilers.sh ;;
    gcc) floors_tested dev '.*' but "${@:2}" ;;
    once) once ;;
    turn) turn "${@:2}" ;;
    parts) printf '%s\n' "${parts[@]}" ;;
    *) echo "usage: in_depth.sh gcc FLOOR... | addresses FLOOR... | longest FLOOR... | threads FLOOR... | coverage | compilers | once | turn [SECONDS] | parts" >&2; exit 2 ;;
  esac
}

part "$@"
