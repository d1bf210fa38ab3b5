#!/bin/bash
# The documentation as a site, from docs/ and the headers, by Doxygen (Debian package doxygen).
#
#   docs/site/make_site.sh FOLDER
set -euo pipefail
folder=$(realpath -m "${1:?usage: make_site.sh FOLDER}")
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
mkdir -p "$folder"
SWAYAW_SITE=$folder SWAYAW_VERSION=$(sed -n 's/^project(swayaw VERSION \([0-9.]*\).*/\1/p' CMakeLists.txt) doxygen docs/site/Doxyfile
echo "the site begins at $folder/index.html"
