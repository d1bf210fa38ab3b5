#!/bin/bash
# Builds swayaw and compares a ship with the recordings in examples/recordings.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")"

./setup.sh
cmake --workflow --preset demo
echo "demo: the report is $PWD/build/release/demo.html"
