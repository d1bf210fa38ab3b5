#!/usr/bin/env bash
# Sweeps over recordings: good ones, one that is no recording, names that are hostile to tables and to SQL.
#   tests/sweep/recordings.sh PROGRAM EXAMPLES FOLDER
set -euo pipefail
program=$(realpath "$1") examples=$(realpath "$2")
rm -rf "$3" && mkdir -p "$3/trials" && cd "$3"
cp "$examples"/*.csv trials/
cp trials/weak_rudder_zz10_10.csv "trials/a, \"b\"; DROP TABLE document --.csv"
echo 'time_s,psi_rad' > trials/empty.csv
printf 'task = "trial"\nruns = ["trials/*.csv"]\n' > trials.toml
"$program" sweep trials.toml --out trials_out --csv trials.csv --json > trials.json 2> /dev/null
fail() { echo "not true: $1" >&2; exit 1; }
[ "$(wc -l < trials.csv)" -eq 5 ] || fail "a header and four items"
grep -q '^0,"a, ""b""; DROP TABLE document --.csv",1.17' trials.csv || fail "a name with commas and quotes is one cell"
grep -q '^1,empty.csv,,,' trials.csv || fail "what cannot be judged has no result"
grep -q 'exit code 1: ' trials.json || fail "and says why"
first=$(sed -n 's/^0,".*--.csv",//p' trials.csv)
[ "$first" = "$(sed -n 's/^3,weak_rudder_zz10_10.csv,//p' trials.csv)" ] || fail "the same recording gives the same numbers"

for case in weak none; do mkdir -p "cases/$case/train"; done
cp trials/weak_rudder_*.csv cases/weak/train
"$program" simulate kvlcc2_l7 --zigzag 10/10 --out cases/none/train/zz.csv 2> /dev/null > /dev/null
printf 'task = "diagnose"\ncases = ["cases/*"]\nship = "kvlcc2_l7"\n' > cases.toml
"$program" sweep cases.toml --out cases_out --json --report page.html > cases.json 2> /dev/null
grep -q '"nothing_missing": 2' cases.json || fail "neither example lacks physics"
before=$(sed 's/"seconds".*//; s/"resumed_at".*//' cases.json)
"$program" sweep cases.toml --out cases_out --json 2> /dev/null > again.json
[ "$before" = "$(sed 's/"seconds".*//; s/"resumed_at".*//' again.json)" ] || fail "the same answer when all is there"
grep -q '"resumed_at": 2' again.json || fail "nothing is made twice"
echo "recordings: trials and diagnoses, with names and files that mean ill"
