#!/usr/bin/env bash
# Seeks inputs that break a reader, by libFuzzer (docs/bad_input.md):
#
#   cmake --preset fuzz && cmake --build --preset fuzz
#   tests/fuzz/run.sh 1800                      every target for half an hour, one after the other
#   tests/fuzz/run.sh 600 recording nmea        these for ten minutes each
#   tests/fuzz/run.sh table                     what all runs so far came to, as the table of docs/bad_input.md
#
# Inputs that reach new code are kept in build/fuzz/corpus, so that the next run goes on from there; one that breaks a promise
# is left in build/fuzz/findings and named in the log. SWAYAW_FUZZERS is the folder of the two programs.
set -euo pipefail
export LC_ALL=C
root=$(cd "$(dirname "$0")/../.." && pwd)
build=$root/build/fuzz
programs=${SWAYAW_FUZZERS:-$build/tests/fuzz}
mkdir -p "$build/log" "$build/corpus" "$build/findings"

longest_input=8192   # bytes: a ship has 3 kB, a sentence of NMEA 80 bytes
longest_time=60      # seconds of an input by the clock, on a machine that does other work beside
most_memory=2048     # MB, of which the sanitizers take most

# A copy of this process tries MATLAB files first, with a limit of its own on what it may ask for: there it is given
# nothing, which is no finding of the fuzzer's.
most_at_once=65536   # MB
export ASAN_OPTIONS=allocator_may_return_null=1

program_of() { case $1 in ship | linear_ship | indices) echo swayaw_fuzz_ships ;; *) echo swayaw_fuzz_files ;; esac; }

targets() { for program in swayaw_fuzz_files swayaw_fuzz_ships; do
  [ -x "$programs/$program" ] && "$programs/$program" -runs=0 | sed -n 's/^\([a-z_]*\)\t.*/\1/p'; done; }

seeds_of() {
  case $1 in ship | linear_ship) echo "$root/ships" ;; esac
  [ -d "$root/tests/fuzz/corpus/$1" ] && echo "$root/tests/fuzz/corpus/$1"
}

fuzz() {  # target seconds
  local target=$1 corpus=$build/corpus/$1 log
  mkdir -p "$corpus"
  log=$build/log/$target-$(date +%Y%m%dT%H%M%S).log
  # shellcheck disable=SC2046
  SWAYAW_FUZZ=$target nice -n 19 "$programs/$(program_of "$target")" "$corpus" $(seeds_of "$target") \
    -max_total_time="$2" -max_len=$longest_input -timeout=$longest_time -rss_limit_mb=$most_memory -malloc_limit_mb=$most_at_once \
    -print_final_stats=1 -artifact_prefix="$build/findings/$target-" >"$log" 2>&1 \
    && echo "$target: no finding" || echo "$target: see $log"
}

# A row for each target: seconds and executions of all runs, edges of the last.
table() {
  echo '| target | seconds | executions | per second | edges | inputs kept | runs that ended by a finding |'
  echo '| --- | ---: | ---: | ---: | ---: | ---: | ---: |'
  for target in $(targets); do
    { cat "$build/log/$target"-*.log 2>/dev/null || true; } | awk -v target="$target" '
      /^Done .* runs in/ { seconds += $5 }
      /^stat::number_of_executed_units/ { count += $2 }
      /^#[0-9]+.* cov: / { for (i = 1; i < NF; ++i) if ($i == "cov:") edges = $(i + 1) > edges ? $(i + 1) : edges
                           for (i = 1; i < NF; ++i) if ($i == "corp:") split($(i + 1), kept, "/") }
      /^SUMMARY:/ { ++found }
      END { if (count) printf "| `%s` | %d | %d | %d | %d | %d | %d |\n", target, seconds, count,
                              seconds ? count / seconds : 0, edges, kept[1], found }'
  done
}

case ${1:-} in
  '' | -h | --help) sed -n '2,12s/^# \{0,1\}//p' "$0"; exit 2 ;;
  table) table; exit ;;
esac
seconds=$1
shift
[ $# -gt 0 ] || set -- $(targets)
for target in "$@"; do fuzz "$target" "$seconds"; done
