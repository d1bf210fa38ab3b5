#!/bin/bash
# Debian packages of this tree: builds them, looks at the manual and at the packages, says how large they are.
#   packaging/make_deb.sh [BUILD]     BUILD: build/debian; the packages are in BUILD/*.deb
# The whole library is compiled; CMAKE_BUILD_PARALLEL_LEVEL says by how many compilers at once.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
build=${1:-build/debian}

./setup.sh packaging/packages.txt
cmake --preset debian -B "$build"
cmake --build "$build"

for page in "$build"/packages/man/*.1; do
  said=$(mandoc -T lint -W warning "$page" || true; MANROFFOPT=-ww man --warnings -E UTF-8 -l "$page" 2>&1 >/dev/null)
  if [[ -n $said ]]; then echo "make_deb: $page: $said" >&2; exit 1; fi
done

rm -f "$build"/*.deb
cpack --config "$build/CPackConfig.cmake" -B "$build"

# nothing that is installed may fall between the packages
stage=$(mktemp -d)
trap 'rm -rf "$stage"' EXIT
cmake --install "$build" --prefix "$stage/usr" >/dev/null
lost=$(comm -13 <(for package in "$build"/*.deb; do dpkg-deb --fsys-tarfile "$package" | tar -t; done | sed 's|^\./||' | sort -u) \
  <(cd "$stage" && find usr ! -type d ! -name LICENSE | sort))
if [[ -n $lost ]]; then echo "make_deb: in no package, for want of a COMPONENT:" $lost >&2; exit 1; fi

lintian --allow-root --fail-on error --suppress-tags initial-upload-closes-no-bugs "$build"/*.deb

for package in "$build"/*.deb; do
  unpacked=$(dpkg-deb --fsys-tarfile "$package" | tar -tv | awk '{sum += $3} END {print sum}')
  printf '%-24s %5.2f MB, unpacked %5.2f MB\n' "$(dpkg-deb -f "$package" Package)" \
    "$(awk "BEGIN {print $(stat -c %s "$package") / 1e6}")" "$(awk "BEGIN {print $unpacked / 1e6}")"
done
