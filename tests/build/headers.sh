#!/bin/bash
# Every public header compiles alone.   tests/build/headers.sh [compiler]
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."

export compiler=${1:-g++}
options="-std=c++20 -fsyntax-only -Wall -Wextra -Wpedantic -Werror -x c++ -isystem /usr/include/eigen3"
for floor in core linear nonlinear identification mismatch; do options+=" -I $floor/include"; done
export options

alone() { echo "#include \"$1\"" | $compiler $options - || { echo "headers: $1 does not compile alone" >&2; return 1; }; }
export -f alone

headers=$(find {core,linear,nonlinear,identification,mismatch}/include -name '*.hpp' | sed 's|^[a-z]*/include/||' | sort)
xargs -P "$(nproc)" -I{} bash -c 'alone {}' <<<"$headers"
echo "headers: $(wc -l <<<"$headers") public headers compile alone by $compiler"
