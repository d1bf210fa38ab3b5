#!/bin/bash
# Runs every command of docs/from_my_spreadsheet.md, in an empty folder, on two exports as a spreadsheet writes them.
#   guide.sh PROGRAM SOURCE_FOLDER
set -euo pipefail
program=$(realpath "$1") source=$(realpath "$2")
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"

# German export: semicolons, decimal commas, degrees, knots, clock times, rudder positive to starboard and not said
export_of() {
  { printf 'Modellversuch KVLCC2, Becken 3\r\n\r\nUhrzeit;Nord [m];Ost [m];Kurs [°];ROT [°/s];Fahrt durchs Wasser [kn];Querfahrt [kn];Ruderlage [°];Welle [1/min]\r\n'
    awk -F, '!/^#/ && $1 != "time_s" {
      t = $1 + 36000; deg = 57.29577951308232; kn = 1.9438444924406
      heading = $4 * deg; while (heading < 0) heading += 360; while (heading >= 360) heading -= 360
      line = sprintf("%02d:%02d:%05.2f;%.3f;%.3f;%.2f;%.3f;%.3f;%.3f;%.1f;%.1f", t / 3600, (t % 3600) / 60, t % 60, $2, $3,
                     heading, $7 * deg, $5 * kn, $6 * kn, -$8 * deg, $9 * 60)
      gsub(/\./, ",", line); printf "%s\r\n", line }' "$1"
  } >"$2"
}
export_of "$source/examples/recordings/weak_rudder_zz10_10.csv" Zickzack.csv
export_of "$source/examples/recordings/weak_rudder_turn35.csv" Drehkreis.csv

swayaw() { "$program" "$@"; }
failed=0
while IFS= read -r line; do
  [[ $line == swayaw\ * ]] || continue
  command=${line%%  \#*}
  # a command whose comment says "refused" must be
  expected=0; [[ $line == *"# refused"* ]] && expected=1
  printf '$ %s\n' "$command"
  status=0; eval "$command" || status=$?
  if [[ $status != "$expected" ]]; then echo "guide: exit $status, $expected expected: $command" >&2; failed=1; fi
done < <(awk '/^```sh/{on=1;next} /^```/{on=0} on' "$source/docs/from_my_spreadsheet.md")
exit $failed
