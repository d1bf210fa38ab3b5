#!/usr/bin/env bash
# Kills a sweep again and again, each time after another fraction of a second, until it ends by itself so often; the
# results are those of a sweep that nobody disturbed.
#   tests/sweep/kills.sh PROGRAM FOLDER KILLS [RANKS]
set -euo pipefail
program=$(realpath "$1") kills=$3 ranks=${4:-0}
rm -rf "$2" && mkdir -p "$2" && cd "$2"
cat > plan.toml <<'END'
task = "zigzag 10/10"
ships = ["kvlcc2", "kvlcc2_l7"]
draws = 6000
seed = 3
tolerance = 1e-6
[vary]
N_v = { relative_sd = 0.05 }
Y_v = { relative_sd = 0.05 }
END
start=()
((ranks == 0)) || start=(mpirun --allow-run-as-root --oversubscribe -n "$ranks")
"$program" sweep plan.toml --out undisturbed --csv undisturbed.csv > /dev/null 2>&1

killed=0 round=0
while ((killed < kills)); do
  round=$((round + 1))
  rm -rf "round$((round - 1))"
  while true; do
    "${start[@]}" "$program" sweep plan.toml --out "round$round" --csv "round$round.csv" > /dev/null 2>&1 &
    process=$!
    sleep "0.$(printf '%03d' $((RANDOM % 350 + 5)))"
    if kill -9 "$process" 2> /dev/null; then killed=$((killed + 1)); fi
    if wait "$process" 2> /dev/null; then break; fi
    ((killed < kills)) || { "$program" sweep plan.toml --out "round$round" --csv "round$round.csv" > /dev/null 2>&1; break; }
  done
  cmp undisturbed.csv "round$round.csv"
done
echo "$killed kills, $round sweeps, each with the results of one that was not disturbed"
