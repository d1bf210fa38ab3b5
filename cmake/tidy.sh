#!/bin/bash
# clang-tidy with the checks of .clang-tidy.
#   cmake/tidy.sh BUILD [SOURCE…]     without sources: those of the library and the program
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

build=${1:?a build folder}
shift
# files that are compiled together have no command of their own
if grep -qs '^SWAYAW_UNITY:BOOL=ON' "$build/CMakeCache.txt"; then
  cmake --preset dev -B "$build/each_file" -D SWAYAW_UNITY=OFF >/dev/null
  build=$build/each_file
fi
if (($# == 0)); then set -- $(git ls-files '*/src/*.cpp' | grep -v '_avx'); fi
# g++ has options that clang does not know
printf '%s\0' "$@" | xargs -0 -n 2 -P "$(nproc)" clang-tidy -p "$build" --quiet --warnings-as-errors='*' \
  --extra-arg=-Wno-unknown-warning-option --extra-arg=-Wno-ignored-optimization-argument
echo "tidy: $# files"
