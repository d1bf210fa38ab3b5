#!/bin/bash
# Builds what compares a ship with recordings, and compares one with those in examples/recordings.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")"

./setup.sh
cmake --workflow --preset demo
echo "demo: the report is $PWD/build/release/demo.html; the whole program: cmake --build --preset release"
