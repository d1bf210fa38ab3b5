#!/usr/bin/env bash
# Prepares the cases of bench/README.md, "Diagnoses that take minutes", each a folder with ship.toml, train/ and holdout/.
#   bench/make_diagnoses.sh SHARED FOLDER       SHARED has data/ and concealed/; what is not there is left out with a word
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
shared=$(realpath "$1") results=$here/../docs/results ships=$here/../ships
mkdir -p "$2" && cd "$2"
there() { [ -d "$1" ] || { echo "[skipped] no recordings in $1" >&2; return 1; }; }
prepare() { python3 "$results/diagnosis.py" prepare "$@"; }

concealed() {
  there "$shared/concealed/$1" || return 0
  mkdir -p "$2" && cp -r "$shared/concealed/$1"/{ship.toml,train,holdout} "$2"
}

esso_osaka() {
  there "$shared/data/esso_osaka" || return 0
  mkdir -p 3_esso_osaka_7_turns_10_hz/train && cp "$ships/esso_osaka_3m.toml" 3_esso_osaka_7_turns_10_hz/ship.toml
  while read -r run begin end; do
    [[ $run != turn_* ]] || prepare "$shared/data/esso_osaka/$run.csv" "3_esso_osaka_7_turns_10_hz/train/$run.csv" \
      --from "$begin" --to "$end" --drop wind_speed_m_s,wind_from_rad
  done < "$results/esso_osaka_runs.txt"
}

# FOLDER EVERY
kvlcc2() {
  there "$shared/data/kvlcc2" || return 0
  mkdir -p "$1/train" && cp "$ships/kvlcc2_pi.toml" "$1/ship.toml"
  for run in hsva_zz10_10_port hsva_zz10_10_stbd hsva_zz20_10_port hsva_zz20_10_stbd; do
    prepare "$shared/data/kvlcc2/$run.csv" "$1/train/$run.csv" --every "$2"
  done
}

concealed open/007 1_open_case
concealed on_board/010 2_case_on_board
esso_osaka
kvlcc2 4_kvlcc2_4_runs_4_hz 5
kvlcc2 5_kvlcc2_4_runs_20_hz 1
