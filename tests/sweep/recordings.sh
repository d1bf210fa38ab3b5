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
# the columns are what identify itself says
printf 'task = "identify"\ncases = ["cases/*"]\nship = "kvlcc2_l7"\nmodel = "mmg"\nfind = ["N_v", "N_r"]\n' > found.toml
"$program" sweep found.toml --out found_out --csv found.csv > /dev/null 2>&1
[ "$(head -1 found.csv)" = "item,case,N_v,N_v_error,N_r,N_r_error" ] || fail "a column of each coefficient and its error"
number=$("$program" identify cases/none/train/zz.csv --ship kvlcc2_l7 --model mmg --find N_v,N_r --json 2> /dev/null |
  sed -n '/"name": "N_v"/,/"value"/s/.*"value": \([-0-9.e]*\).*/\1/p' | head -1)
grep -q "^0,none,$number," found.csv || fail "$number is what identify says"
for wrong in 'model = "linear"' 'model = "mmg"\nfind = []' 'model = "mmg"\nfind = ["N_v"]\nprior = 1'; do
  printf 'task = "identify"\ncases = ["cases/*"]\nship = "kvlcc2_l7"\n'"$wrong\n" > wrong.toml
  if "$program" sweep wrong.toml --out wrong_out 2> wrong.txt; then fail "$wrong is refused"; fi
  [ "$(wc -l < wrong.txt)" -eq 1 ] && grep -q '^wrong.toml:[0-9]*:' wrong.txt || fail "$wrong in one line with its place"
done
echo "recordings: trials, identifications and diagnoses, with names and files that mean ill"
