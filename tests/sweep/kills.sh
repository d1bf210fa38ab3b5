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

# one of the processes of a sweep, any: the program, mpirun, a rank
one_of() { pgrep -f "sweep plan.toml --out $1 " | shuf -n 1; }

killed=0 round=0
while ((killed < kills)); do
  round=$((round + 1)) ended=1
  rm -rf "round$((round - 1))"
  while ((ended != 0)); do
    (exec "${start[@]}" "$program" sweep plan.toml --out "round$round" --csv "round$round.csv") > /dev/null 2>&1 &
    process=$!
    if ((killed < kills)); then
      sleep "$(awk -v u=$RANDOM -v begin=$((ranks > 0 ? 250 : 5)) 'BEGIN { print (begin + u / 32768 * 350) / 1000 }')"
      if kill -9 "$(one_of "round$round")" 2> /dev/null; then killed=$((killed + 1)); fi
    fi
    ended=0
    wait "$process" 2> /dev/null || ended=$?
    # ranks that mpirun left behind write on, and hold the folder
    while ((ended != 0)) && [[ -n $(one_of "round$round") ]]; do sleep 0.05; done
  done
  cmp undisturbed.csv "round$round.csv"
done
echo "$killed kills, $round sweeps, each with the results of one that was not disturbed"
