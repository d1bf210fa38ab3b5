#!/bin/bash
# A consumer without CMake: what pkg-config says is all that he needs.   pkg_config.sh PREFIX LIBDIR COMPILER
set -euo pipefail
prefix=$1 libdir=$2 compiler=$3
command -v pkg-config >/dev/null || { echo "[skipped] consumer.pkg_config: no pkg-config"; exit 77; }

export PKG_CONFIG_PATH=$prefix/$libdir/pkgconfig LD_LIBRARY_PATH=$prefix/$libdir
"$compiler" -std=c++20 "$(dirname "${BASH_SOURCE[0]}")/project/main.cpp" -o "$prefix/by_pkg_config" \
  $(pkg-config --cflags --libs swayaw)
"$prefix/by_pkg_config" "$prefix/share/swayaw/ships/kvlcc2_l7.toml"
