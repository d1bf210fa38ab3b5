#!/bin/bash
# Proves that a tarball of the sources builds its pages without a network and without npm: unpacks it, configures, and
# builds the part that has Plotly in it.   packaging/check_source.sh swayaw-VERSION.tar.xz      exit code 77: not possible here
set -euo pipefail
tarball=$(realpath -e "${1:?usage: check_source.sh TARBALL}")
unshare -rn true 2>/dev/null || { echo "[skipped] check_source: no right to unshare the network"; exit 77; }

(cd "${tarball%/*}" && sha256sum --quiet --check "$tarball.sha256")
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
tar -x -C "$scratch" --strip-components 1 -f "$tarball"
(cd "$scratch/app/report/plotly" && sha256sum --quiet --check plotly-basic.min.js.sha256)

unshare -rn cmake --no-warn-unused-cli -S "$scratch" -B "$scratch/build" -G Ninja -D BUILD_TESTING=OFF -D SWAYAW_BUILD_EXAMPLES=OFF \
  -D SWAYAW_BUILD_BENCH=OFF -D SWAYAW_BUILD_PYTHON=OFF -D NPM_EXECUTABLE=/absent >/dev/null
unshare -rn cmake --build "$scratch/build" --target swayaw_report >/dev/null
grep -q 'plotly.js (basic - minified)' "$scratch/build/app/report/libswayaw_report.a" ||
  { echo "check_source: the pages have no Plotly in them" >&2; exit 1; }
echo "check_source: ${tarball##*/} configures, and its pages build, without a network"
