#!/bin/bash
# The sources of the last commit, and Plotly in them, as one file that builds without a network: swayaw-VERSION.tar.xz and
# its checksum.   packaging/make_source.sh [FOLDER] [PLOTLY]
#   FOLDER   where they are put: build
#   PLOTLY   a plotly-basic.min.js; npm fetches the one of app/report/package-lock.json, whose checksum npm compares
# The same commit makes the same file.
set -euo pipefail
output=$(realpath "${1:-build}")
if (($# > 1)); then plotly=$(realpath -e "$2"); fi
cd "$(dirname "${BASH_SOURCE[0]}")/.."

version_in() { sed -nE "s/$2/\1/p" "$1"; }
version=$(version_in CMakeLists.txt '^project\(swayaw VERSION ([0-9.]+).*')
cited=$(version_in CITATION.cff '^version: ([0-9.]+)$')
if [[ $version != "$cited" ]]; then echo "make_source: CITATION.cff has version $cited, CMakeLists.txt $version" >&2; exit 1; fi
if [[ -n $(git status --porcelain --untracked-files=no) ]]; then
  echo "make_source: what is not committed is left out" >&2
fi

scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
name=swayaw-$version
git archive --prefix="$name/" HEAD | tar -x -C "$scratch"

if [[ -z ${plotly:-} ]]; then
  mkdir "$scratch/npm"
  cp app/report/package.json app/report/package-lock.json "$scratch/npm"
  (cd "$scratch/npm" && npm ci --prefer-offline --ignore-scripts --no-audit --no-fund --loglevel=error >/dev/null)
  plotly=$scratch/npm/node_modules/plotly.js-basic-dist-min/plotly-basic.min.js
fi
mkdir "$scratch/$name/app/report/plotly"
cp "$plotly" "$scratch/$name/app/report/plotly/plotly-basic.min.js"
if [[ -f ${plotly%/*}/LICENSE ]]; then cp "${plotly%/*}/LICENSE" "$scratch/$name/app/report/plotly"; fi
(cd "$scratch/$name/app/report/plotly" && sha256sum plotly-basic.min.js >plotly-basic.min.js.sha256)

mkdir -p "$output"
tar -C "$scratch" --sort=name --mtime="@$(git log -1 --format=%ct)" --owner=0 --group=0 --numeric-owner --mode=go-w \
  -c "$name" | xz -9 >"$output/$name.tar.xz"
cd "$output"
sha256sum "$name.tar.xz" | tee "$name.tar.xz.sha256"
