#!/bin/bash
# Builds what compares a ship with recordings, and compares one with those in examples/recordings.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")"

./setup.sh
cmake --workflow --preset demo
cat <<END

The report is $PWD/build/release/demo.html: open it in a browser.

It says where ship file and recordings differ. Why, says the whole program, some minutes of building further:

  cmake --build --preset release --target swayaw
  build/release/app/swayaw diagnose ships/kvlcc2_l7.toml examples/recordings/*.csv --report page.html

The recordings were made with a rudder that has 82 % of its lift. Nobody tells the program; its page does.
With your own: swayaw import LOG --out run.csv, then swayaw diagnose SHIP run.csv (docs/from_my_spreadsheet.md).
END
