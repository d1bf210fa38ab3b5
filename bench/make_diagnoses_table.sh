#!/usr/bin/env bash
# Times the cases of bench/make_diagnoses.sh and puts their table into bench/README.md.
#   bench/make_diagnoses_table.sh PROGRAM FOLDER
set -euo pipefail
program=$(realpath "$1") cases=$(realpath "$2")
cd "$(dirname "$0")"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
"$program" --benchmark_format=json --benchmark_filter=^diagnosis_ --diagnoses="$cases" > "$work/times.json"
mkdir "$work/tables"
python3 - "$work/times.json" > "$work/tables/diagnoses.md" << 'PYTHON'
import json
import sys

stages = {"before": ["calibrating on reference runs", "fitting the baseline", "fitting the baseline, form and instruments taken for inexact"],
          "first": ["trying every effect"],
          "further": ["trying a further effect", "once more, surge, sway and yaw apart", "a map of what has no name"],
          "after": ["where, and what next"]}
print("| line | samples | found | processor time | over the line before | of it baseline | first effect | further effects | words and advice | peak memory |")
print("| --- | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: |")
for line in json.load(open(sys.argv[1]))["benchmarks"]:
    if line.get("error_occurred"):
        continue
    parts = {name: sum(line.get(stage, 0.0) for stage in some) for name, some in stages.items()}
    whole = sum(parts.values())
    ratio = f'{line["over_line_before"]:.2f}' if "over_line_before" in line else ""
    shares = " | ".join(f"{100 * part / whole:.0f} %" for part in parts.values())
    print(f'| {line["name"].split("/")[0]} | {line["samples"]:.0f} | {line["found"]:.0f} | {whole:.1f} s | {ratio} | {shares} | {line["peak_MB"]:.0f} MB |')
PYTHON
../docs/papers/put_tables.sh README.md "$work/tables"
