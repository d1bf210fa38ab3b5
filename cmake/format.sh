#!/bin/bash
# Lays out the C++ files of the project; with --check, says which are laid out otherwise and fails.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

how=(-i)
if [[ ${1:-} == --check ]]; then how=(--dry-run -Werror); fi
git ls-files -z '*.cpp' '*.hpp' | xargs -0 -n 40 -P "$(nproc)" clang-format "${how[@]}"
