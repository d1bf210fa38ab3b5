#!/usr/bin/env python3
"""What each object costs to compile: processor seconds and peak memory of the compiler.

As a compiler launcher it adds a line to compile_cost.csv in the build folder:

    cmake --preset dev -D CMAKE_CXX_COMPILER_LAUNCHER=$PWD/cmake/compile_cost.py
    cmake --build --preset dev

Then `cmake/compile_cost.py --table build/dev/compile_cost.csv` prints a Markdown table, the dearest first, and
`--limit 25 700` fails when an object needs more than 25 s or 700 MB. With `--against OTHER.csv` it prints what each
target took there and here.
"""

import argparse
import csv
import os
import re
import resource
import subprocess
import sys


def launch(command):
    status = subprocess.call(command)
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    if "-o" in command and "-c" in command:
        built = command[command.index("-o") + 1]
        row = f"{built},{used.ru_utime + used.ru_stime:.2f},{used.ru_maxrss / 1024:.0f}\n"
        log = os.environ.get("SWAYAW_COMPILE_COST", "compile_cost.csv")
        with open(log, "a", encoding="utf-8") as file:
            file.write(row)  # one short write: lines of parallel compilers do not mix
    return status


def read(path):
    """Seconds and megabytes by object; of an object compiled twice the last line counts."""
    with open(path, newline="", encoding="utf-8") as file:
        return {built: (float(seconds), float(memory)) for built, seconds, memory in csv.reader(file)}


def short(built):
    """app/CMakeFiles/swayaw.dir/src/main.cpp.o is app/src/main.cpp; Unity/unity_judging_cxx.cxx.o the group judging of app"""
    parts = built.split("/")
    if "CMakeFiles" in parts:
        place = parts.index("CMakeFiles")
        parts = parts[:place] + parts[place + 2 :]
    group = re.fullmatch(r"unity_(\w+)_cxx\.cxx\.o", parts[-1])
    return f"{'/'.join(parts[:-2])}, {group[1]}" if group else "/".join(parts).removesuffix(".o")


def print_table(costs, rows):
    total = sum(seconds for seconds, _ in costs.values())
    print(f"{len(costs)} objects, {total:.0f} s of processor time.\n")
    print("| object | seconds | MB |\n| --- | ---: | ---: |")
    dearest = sorted(costs.items(), key=lambda item: -item[1][0])
    for built, (seconds, memory) in dearest[:rows]:
        print(f"| {short(built)} | {seconds:.1f} | {memory:.0f} |")


def target(built):
    """tests/app/CMakeFiles/swayaw_test_app.dir/tune_command_test.cpp.o belongs to tests/app"""
    return built.split("/CMakeFiles/")[0]


def by_target(costs):
    sums = {}
    for built, (seconds, _) in costs.items():
        objects, total = sums.get(target(built), (0, 0.0))
        sums[target(built)] = (objects + 1, total + seconds)
    return sums


def print_targets(before, after):
    """Of the targets that both have."""
    rows = [(name, *before[name], *after[name]) for name in sorted(before) if name in after]
    rows.append(("all of these", *(sum(column) for column in list(zip(*rows))[1:])))
    print("| target | objects | seconds | objects | seconds |\n| --- | ---: | ---: | ---: | ---: |")
    for name, objects, seconds, objects_after, seconds_after in rows:
        print(f"| {name} | {objects} | {seconds:.0f} | {objects_after} | {seconds_after:.0f} |")


def above(costs, limit):
    return [built for built, (seconds, memory) in costs.items() if seconds > limit[0] or memory > limit[1]]


def report(arguments):
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--table", required=True, metavar="CSV", help="what the launcher has written")
    parser.add_argument("--rows", type=int, default=30)
    parser.add_argument("--against", metavar="CSV", help="what it has written of another build")
    parser.add_argument("--limit", type=float, nargs=2, metavar=("SECONDS", "MB"))
    options = parser.parse_args(arguments)
    costs = read(options.table)
    if options.against:
        print_targets(by_target(read(options.against)), by_target(costs))
        return 0
    print_table(costs, options.rows)
    dear = above(costs, options.limit) if options.limit else []
    for built in dear:
        print(f"compile_cost: {short(built)} is above the limit", file=sys.stderr)
    return 1 if dear else 0


if __name__ == "__main__":
    starts_with_option = len(sys.argv) < 2 or sys.argv[1].startswith("-")
    sys.exit(report(sys.argv[1:]) if starts_with_option else launch(sys.argv[1:]))
