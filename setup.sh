#!/bin/bash
# Installs the Debian packages of packages.txt, and of lists that are named, if they are missing; does nothing when all are
# there.   setup.sh [LIST…]
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")"

wanted=$(cat packages.txt "$@")
# npm is often installed from elsewhere than Debian
if command -v npm >/dev/null; then wanted=$(grep -vx npm <<<"$wanted"); fi

installed=$(dpkg-query -W -f '${Package} ${db:Status-Status}\n' $wanted 2>/dev/null | sed -n 's/ installed$//p' || true)
missing=$(grep -vxF "$installed" <<<"$wanted" || true)
if [[ -z $missing ]]; then exit 0; fi

echo "setup: installing" $missing
as_root=(env DEBIAN_FRONTEND=noninteractive)
if ((EUID != 0)); then as_root=(sudo "${as_root[@]}"); fi
"${as_root[@]}" apt-get -qq update
"${as_root[@]}" apt-get -qq install -y --no-install-recommends $missing >/dev/null
