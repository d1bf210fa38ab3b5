#!/bin/bash
# The first screens of the pages as pictures, into this folder; opens every page in headless Chromium on the way.
#
#   docs/pages/make_pictures.sh PROGRAM
set -euo pipefail
program=$(realpath "$1")
cd "$(dirname "${BASH_SOURCE[0]}")"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
node ../../tests/pages/pages.mjs "$program" "$(realpath ../..)" "$work" "$work/shots"
cp "$work/shots/diagnose.png" .
