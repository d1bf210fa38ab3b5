#!/usr/bin/env bash
# Runs the benchmarks and puts their table into bench/README.md.
#   bench/make_readme.sh PROGRAM
set -euo pipefail
program=$(realpath "$1")
cd "$(dirname "$0")"
{
  sed '/^<!-- table -->$/q' README.md
  printf '\n%s, %s, %s.\n\n```\n' "$(lscpu | sed -n 's/^Model name: *//p')" "$(g++ --version | head -1)" "$(uname -m)"
  "$program" --benchmark_min_time=0.5 2>&1 | grep -E "^(reference|import|linear|mmg|pi_|kvlcc2|simulator|states|noise|regression|trajectory|diagnosis|Benchmark|-)" | sed "s/\(x_atan2=[0-9.k]*\)s/\1/" | cut -c1-300
  printf '```\n'
} > README.md.new
mv README.md.new README.md
