#!/usr/bin/env bash
# Makes the table of K and T in docs/trial.md from recorded zigzags.
#   docs/results/make_trial_nomoto.sh SWAYAW_PROGRAM FOLDER_WITH_FOLDERS_OF_RECORDINGS
set -euo pipefail
program=$(realpath "$1") recordings=$(realpath "$2")
cd "$(dirname "$0")/.."

row() {  # LENGTH FILE
  "$program" trial "$2" --length "$1" --json 2> /dev/null | python3 -c '
import json, os, sys
result = json.load(sys.stdin)
trial, length = result["runs"][0], result["length_m"]
nomoto = trial.get("nomoto") or {}
fit, worked = nomoto.get("least_squares"), nomoto.get("worked")
if fit and worked:
    unit = length / trial["approach_speed_m_s"]["value"]
    told = lambda x, by: "{:.2f} ± {:.2f}".format(x["value"] * by, x["standard_error"] * by)
    bare = lambda x, by: "{:.2f}".format(x["value"] * by)
    cells = [os.path.basename(sys.argv[1]), trial["manoeuvre"], told(fit["K_1_s"], unit), bare(worked["K_1_s"], unit),
             told(fit["T_s"], 1 / unit), bare(worked["T_s"], 1 / unit)]
    print("| " + " | ".join(cells) + " |")
' "$2" || true
}

{
  sed '/^<!-- zigzags -->$/q' trial.md
  printf '\n| recording | manoeuvre | K'"'"', least squares | Nomoto | T'"'"', least squares | Nomoto |\n| --- | --- | ---: | ---: | ---: | ---: |\n'
  for file in "$recordings"/kvlcc2/*zz*.csv; do row 7 "$file"; done
  for file in "$recordings"/kcs/*zigzag*.csv; do row 230 "$file"; done
  for file in "$recordings"/esso_osaka/zigzag*.csv; do row 3 "$file"; done
  printf '\n'
  sed '1,/^<!-- end of zigzags -->$/{/^<!-- end of zigzags -->$/!d}' trial.md
} > trial.md.new
mv trial.md.new trial.md
