#!/usr/bin/env bash
# The table "What it costs" of docs/sweep.md, as Markdown.
#   docs/make_sweep_costs.sh PROGRAM [FOLDER]      FOLDER: where the results go and stay, 200 MB; a new one unless given
set -euo pipefail
program=$(realpath "$1") folder=${2:-$(mktemp -d)}
mkdir -p "$folder" && cd "$folder"

plan() { printf 'task = "%s"\nships = ["%s"]\ndraws = %d\ntolerance = 1e-6\n%s\n' "$2" "$3" "$4" "$5" > "$1.toml"; }
hull='[vary]
N_v = { relative_sd = 0.05 }
N_r = { relative_sd = 0.05 }
Y_v = { relative_sd = 0.05 }'
plan linear 'zigzag 10/10' tanker97_abc 1000000 'confidence = true'
plan mmg 'zigzag 10/10' kvlcc2 100000 "$hull"
plan pi 'zigzag 10/10' kvlcc2_pi 4000 'confidence = true'
plan turns 'turn 35' kvlcc2 4000 "$hull"
plan indices indices kvlcc2 20000 "$hull"

seconds_of() { python3 -c 'import json, sys; print(json.load(sys.stdin)["seconds"])'; }
best() {  # PLAN HOW…: least of three
  local plan=$1 least='' now
  shift
  for _ in 1 2 3; do
    rm -rf results
    now=$("$@" "$program" sweep "$plan.toml" --out results --json ${threads:+--threads $threads} 2> /dev/null | seconds_of)
    least=$(awk -v a="${least:-$now}" -v b="$now" 'BEGIN { print (a < b ? a : b) }')
  done
  echo "$least"
}
row() {  # WORDS PLAN ITEMS
  local one two ranks bytes
  one=$(threads=1 best "$2")
  two=$(threads=2 best "$2")
  bytes=$(stat -c %s results/sweep.sqlite)
  ranks=-
  if command -v mpirun > /dev/null; then ranks=$(threads='' best "$2" mpirun --allow-run-as-root --oversubscribe -n 2); fi
  awk -v words="$1" -v n="$3" -v a="$one" -v b="$two" -v r="$ranks" -v bytes="$bytes" 'BEGIN {
    printf "| %s | %d | %.3g s | %.3g s | %s | %.3g | %.0f |\n", words, n, a, b, r == "-" ? "-" : sprintf("%.3g s", r), n / b, bytes / n }'
}
echo '| items | how many | one thread | two threads | two ranks | items a second, two threads | bytes an item |'
echo '| --- | ---: | ---: | ---: | ---: | ---: | ---: |'
row 'zigzags 10/10 of a linear ship, six coefficients drawn' linear 1000000
row 'zigzags 10/10 of the KVLCC2 (MMG) at 1e-6, three derivatives drawn' mmg 100000
row 'the same of a PI model, one by one' pi 4000
row 'turns 35 of the KVLCC2' turns 4000
row 'steering indices of the KVLCC2, exact linearization' indices 20000
[ $# -gt 1 ] || rm -rf "$folder"
