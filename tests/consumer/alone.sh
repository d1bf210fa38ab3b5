#!/bin/bash
# A consumer that has a compiler, CMake, Eigen, Boost, fmt, toml++ and the Jet header, and nothing else: no npm, no CLI11,
# no JSON, no xsimd, no GeographicLib, no libmatio, no network. He adds swayaw to his project and links swayaw::nonlinear.
#
# The root he works in is made of the files of those Debian packages and of what they depend on.
#   tests/consumer/alone.sh [SCRATCH]      exit code 77: not possible here
set -euo pipefail
sources=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)

skip() { echo "[skipped] consumer.alone: $1"; exit 77; }

unshare -rmn true 2>/dev/null || skip "no right to unshare mounts and network"
command -v dpkg-query apt-cache >/dev/null || skip "not Debian"
wanted="g++ cmake ninja-build libeigen3-dev libboost-dev libfmt-dev libtomlplusplus-dev"
dpkg-query -s $wanted libceres-dev >/dev/null 2>&1 || skip "packages are missing"

if (($#)); then scratch=$1 && mkdir -p "$scratch" && scratch=$(realpath "$scratch"); else scratch=$(mktemp -d) && trap 'rm -rf "$scratch"' EXIT; fi
root=$scratch/root
rm -rf "$root"
mkdir -p "$root"/{usr/bin,usr/sbin,usr/lib,usr/lib64,proc,dev,tmp,swayaw,consumer}
for folder in bin sbin lib lib64; do ln -s usr/$folder "$root/$folder"; done

packages=$(apt-cache depends --recurse --installed --no-recommends --no-suggests --no-conflicts --no-breaks \
  --no-replaces --no-enhances $wanted dash coreutils | grep -v '^[ |<]' | sort -u)
{
  dpkg-query -L $packages 2>/dev/null || true  # some names are virtual
  dpkg-query -L libceres-dev | grep '/usr/include/ceres/\(jet[a-z_]*\.h\|internal/\)'
} | grep -v '^/usr/share/\(doc\|man\|locale\|info\)/' | sort -u |
  while read -r file; do if [[ -L $file || -f $file ]]; then echo "${file#/}"; fi; done |
  tar -C / -c -T - --ignore-failed-read | tar -C "$root" -x --keep-directory-symlink
cp -a "$sources"/tests/consumer/alone/. "$root/consumer"

for absent in usr/bin/npm usr/include/CLI usr/include/nlohmann usr/include/xsimd usr/include/GeographicLib usr/include/matio.h usr/include/catch2; do
  if [[ -e $root/$absent ]]; then echo "consumer.alone: $absent is in the root" >&2; exit 1; fi
done

export root sources
unshare -rmn bash -euc '
  mount --rbind /dev "$root/dev"
  mount --rbind "$sources" "$root/swayaw"
  exec chroot "$root" /usr/bin/env -i PATH=/usr/bin:/bin sh -euc "
    cmake -S /consumer -B /tmp/build -G Ninja -D CMAKE_CXX_COMPILER=g++ -D CMAKE_BUILD_TYPE=Debug -D CMAKE_CXX_FLAGS_DEBUG=-O0
    cmake --build /tmp/build
    /tmp/build/first_overshoot /swayaw/ships/kvlcc2_l7.toml"'
