#!/bin/bash
# Installs the packages in a Debian that has nothing else, uses them as a stranger would, takes them out again, and prints
# what it took as the table of docs/install.md.
#   packaging/fresh_root.sh FOLDER_WITH_DEBS [ROOT]      as root; ROOT: a minimal Debian 12 from debootstrap, which is copied
set -euo pipefail
debs=$(realpath -e "${1:?usage: fresh_root.sh FOLDER_WITH_DEBS [ROOT]}")
base=${2:-}
sources=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
scratch=$(mktemp -d)
trap 'rm -rf --one-file-system "$scratch"' EXIT
root=$scratch/root

rows=()
measured() {  # measured "what is done" command…
  local begin=$EPOCHREALTIME
  "${@:2}" >"$scratch/said" 2>&1 || { cat "$scratch/said" >&2; echo "fresh_root: failed: $1" >&2; exit 1; }
  rows+=("| $1 | $(awk -v a="$begin" -v b="$EPOCHREALTIME" 'BEGIN {printf "%.2f", b - a}') |")
  echo "fresh_root: $1" >&2
}
inside() {  # a shell command in the root, which has its own /proc where the kernel lets it
  unshare -m bash -c 'mount -t proc proc "$0/proc" 2>/dev/null || true
    exec chroot "$0" /usr/bin/env -i HOME=/root LANG=C.UTF-8 DEBIAN_FRONTEND=noninteractive \
      PATH=/usr/sbin:/usr/bin:/sbin:/bin sh -euc "$1"' "$root" "$1"
}
megabytes() { du -sx --block-size=1MB --exclude="$root/var" --exclude="$root/debs" "$root" | cut -f1; }
install_packages() { inside "apt-get -qq install -y --no-install-recommends $*"; }

if [[ -n $base ]]; then cp -a "$base" "$root"; else debootstrap --variant=minbase bookworm "$root" >/dev/null; fi
mkdir -p "$root/debs" "$root/srv"
cp "$debs"/*.deb "$root/debs"
cp -r "$sources/tests/consumer/project" "$root/srv"
measured "lists of packages, \`apt-get update\`" inside "apt-get -qq update"
bare=$(megabytes)

measured "\`apt install ./swayaw_*.deb ./libswayaw0*.deb\`" install_packages /debs/swayaw_*.deb /debs/libswayaw0*.deb
with_program=$(megabytes)
measured "\`swayaw --version\`" inside "swayaw --version"
measured "\`swayaw simulate kvlcc2 --zigzag 10/10\`" inside "swayaw simulate kvlcc2 --zigzag 10/10 | grep overshoot"
measured "\`swayaw diagnose … --report page.html\`, two example recordings" inside "
  cd /srv && swayaw diagnose kvlcc2_l7 /usr/share/doc/swayaw/examples/weak_rudder_*.csv --report page.html
  grep -q 'plotly.js (basic' page.html"
measured "a ship file of the package, \`swayaw linearize /usr/share/swayaw/ships/kcs.toml\`" \
  inside "swayaw linearize /usr/share/swayaw/ships/kcs.toml"
measured "manual and completion are there" inside "
  test -s /usr/share/man/man1/swayaw.1.gz && test -s /usr/share/man/man1/swayaw-simulate.1.gz
  bash -c '. /usr/share/bash-completion/completions/swayaw; COMP_WORDS=(swayaw simul); COMP_CWORD=1; _swayaw
    test \"\${COMPREPLY[*]}\" = simulate'"

measured "\`apt install ./python3-swayaw*.deb\`, with numpy" install_packages /debs/python3-swayaw_*.deb
with_python=$(megabytes)
measured "\`python3 -c 'import swayaw'\`, and a zigzag" inside "python3 -c '
import importlib.metadata, math, swayaw
assert importlib.metadata.version(\"swayaw\") == swayaw.__version__
print(swayaw.zigzag(swayaw.published_ship(\"kvlcc2\"), math.radians(10), math.radians(10)).reversals[0])'"

measured "g++, cmake and pkg-config of Debian" install_packages g++ cmake make pkg-config
with_compiler=$(megabytes)
measured "\`apt install ./libswayaw-dev*.deb\`" install_packages /debs/libswayaw-dev_*.deb
with_headers=$(megabytes)
ship=/usr/share/swayaw/ships/kvlcc2_l7.toml
measured "a program with CMake: configure, build, run" inside "
  cmake -S /srv/project -B /srv/build -D CMAKE_BUILD_TYPE=Release && cmake --build /srv/build
  /srv/build/first_overshoot $ship"
measured "the same program with pkg-config" inside "
  g++ -std=c++20 -O2 /srv/project/main.cpp -o /srv/first_overshoot \$(pkg-config --cflags --libs swayaw)
  /srv/first_overshoot $ship"

measured "all of it taken out again, nothing left" inside "
  apt-get -qq purge -y 'libswayaw*' swayaw python3-swayaw
  test -z \"\$(find /usr /etc /var/lib -name '*swayaw*')\""

echo "| in a Debian 12 of $bare MB | s |"
echo "| --- | ---: |"
printf '%s\n' "${rows[@]}"
echo
echo "| package | MB | unpacked, MB | on the disk with what it depends on, MB |"
echo "| --- | ---: | ---: | ---: |"
size_row() {  # of one package, and how much larger the root became
  local file=$(ls "$debs"/$1_*.deb)
  local unpacked=$(dpkg-deb --fsys-tarfile "$file" | tar -tv | awk '{sum += $3} END {print sum}')
  printf '| `%s` | %.1f | %.1f | %s |\n' "$(dpkg-deb -f "$file" Package)" \
    "$(awk "BEGIN {print $(stat -c %s "$file") / 1e6}")" "$(awk "BEGIN {print $unpacked / 1e6}")" "$2"
}
size_row 'libswayaw0*' "in the next"
size_row swayaw $((with_program - bare))
size_row python3-swayaw $((with_python - with_program))
size_row libswayaw-dev $((with_headers - with_compiler))
