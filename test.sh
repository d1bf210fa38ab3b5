#!/bin/bash
# Builds swayaw with warnings as errors and runs all tests; fails when one of them fails.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")"

./setup.sh
cmake --workflow --preset test
