#!/usr/bin/env python3
"""Lines and branches of each floor that its tests run, from the counts of a build with the preset `coverage`.

    coverage_table.py BUILD FLOOR… [--tables FOLDER] [--lines 95 --branches 85 --of core,linear,nonlinear]

Prints the table of the floors and, with --tables, writes it to FOLDER/floors.md and the files of each floor to
FOLDER/FLOOR.md. Fails where a floor of --of is below --lines or --branches percent. `--missed FLOOR` prints what none of the
tests runs, as FILE:LINE.
"""

import argparse
import collections
import json
import os
import subprocess
import sys

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))


def llvm(tool, *words):
    """Output of a program of LLVM 14, which Debian also installs without the number."""
    return subprocess.run([tool, *words], check=True, stdout=subprocess.PIPE, text=True).stdout


def profile(build, floors):
    """The counts of these floors' tests in one file."""
    raw = [f"{build}/profiles/{floor}.profraw" for floor in floors]
    merged = f"{build}/profiles/{'_'.join(floors)}.profdata"
    llvm("llvm-profdata", "merge", "-o", merged, *raw)
    return merged


def binaries(build, tests):
    """The tests, each linked with its whole floor, so that a file that no test needs counts as one that none runs."""
    first, *others = [f"{build}/tests/{name}/swayaw_test_{name}" for name in tests]
    return [first, *(word for name in others for word in ("-object", name))]


def covered(build, floor, tests):
    """{file: ({line: count}, {place: [times true, times false]})} of the floor's sources, under the tests of some floors.

    Lines and branches of a template count once, as run if any instance ran them. Conditions that the compiler decides are
    no branches, nor is what an exception may leave.
    """
    words = [f"-instr-profile={profile(build, tests)}", *binaries(build, tests)]
    kept = [f"{ROOT}/{floor}/include/", f"{ROOT}/{floor}/src/"]
    files = collections.defaultdict(lambda: ({}, {}))

    def ours(name):
        return any(name.startswith(folder) for folder in kept)

    name = ""
    for line in llvm("llvm-cov", "export", "-format=lcov", *words).splitlines():
        if line.startswith("SF:"):
            name = line[3:]
        elif line.startswith("DA:") and ours(name):
            number, count = line[3:].split(",")[:2]
            files[name][0][int(number)] = int(count)
    for function in json.loads(llvm("llvm-cov", "export", *words))["data"][0]["functions"]:
        for row in function["branches"]:
            name = function["filenames"][row[6]]
            if ours(name):
                times = files[name][1].setdefault(tuple(row[:4]), [0, 0])
                times[0] += row[4]
                times[1] += row[5]
    return {os.path.relpath(name, ROOT): counts for name, counts in files.items()}


class Share:
    """How many of how many, in lines and branches."""

    def __init__(self, files):
        self.lines = sum(len(lines) for lines, _ in files)
        self.run = sum(count > 0 for lines, _ in files for count in lines.values())
        self.branches = 2 * sum(len(branches) for _, branches in files)
        self.taken = sum(count > 0 for _, branches in files for times in branches.values() for count in times)

    def line_percent(self):
        return 100 * self.run / self.lines if self.lines else 100.0

    def branch_percent(self):
        return 100 * self.taken / self.branches if self.branches else 100.0

    def cells(self):
        branches = f"{self.branch_percent():.1f} | {self.branches}" if self.branches else "– | 0"
        return f"{self.line_percent():.1f} | {self.lines} | {branches}"


def floor_table(own, together):
    rows = [
        "| floor | lines run, % | lines | branches taken, % | branches | by its own tests alone: lines, % | branches, % |",
        "| --- | ---: | ---: | ---: | ---: | ---: | ---: |",
    ]
    for floor, files in together.items():
        alone = Share(own[floor].values())
        rows.append(
            f"| {floor} | {Share(files.values()).cells()} | {alone.line_percent():.1f} | {alone.branch_percent():.1f} |"
        )
    return "\n".join(rows)


def file_table(files):
    """One row for each file that is not run whole, the most outcomes missed first."""
    shares = {name: Share([counts]) for name, counts in files.items()}
    missed = {name: s.lines - s.run + s.branches - s.taken for name, s in shares.items()}
    rows = sorted((name for name in shares if missed[name]), key=lambda name: (-missed[name], name))
    table = ["| file | lines run, % | lines | branches taken, % | branches |", "| --- | ---: | ---: | ---: | ---: |"]
    table += [f"| {name} | {shares[name].cells()} |" for name in rows]
    whole = len(shares) - len(rows)
    return "\n".join(table) + f"\n\n{whole} more files are run whole."


def print_missed(files):
    for name in sorted(files):
        lines, branches = files[name]
        for number in sorted(number for number, count in lines.items() if count == 0):
            print(f"{name}:{number}: not run")
        for (line, column, *_), (true, false) in sorted(branches.items()):
            if (true == 0) != (false == 0):
                print(f"{name}:{line}:{column}: never {'true' if true == 0 else 'false'}")


def write(folder, name, table):
    with open(f"{folder}/{name}.md", "w", encoding="utf-8") as file:
        file.write(table + "\n")


def main():
    asked = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    asked.add_argument("build")
    asked.add_argument("floors", nargs="+")
    asked.add_argument("--tables")
    asked.add_argument("--missed")
    asked.add_argument("--lines", type=float, default=0.0)
    asked.add_argument("--branches", type=float, default=0.0)
    asked.add_argument("--of", default="")
    told = asked.parse_args()

    if told.missed:
        print_missed(covered(told.build, told.missed, told.floors))
        return 0
    own = {floor: covered(told.build, floor, [floor]) for floor in told.floors}
    together = {floor: covered(told.build, floor, told.floors) for floor in told.floors}
    table = floor_table(own, together)
    print(table)
    if told.tables:
        write(told.tables, "floors", table)
        for floor, files in together.items():
            write(told.tables, floor, file_table(files))
    status = 0
    for floor in filter(None, told.of.split(",")):
        share = Share(together[floor].values())
        if share.line_percent() < told.lines or share.branch_percent() < told.branches:
            print(
                f"coverage: {floor} has {share.line_percent():.1f} % of its lines and {share.branch_percent():.1f} % of"
                f" its branches run by tests; {told.lines:g} % and {told.branches:g} % are wanted",
                file=sys.stderr,
            )
            status = 1
    return status


if __name__ == "__main__":
    sys.exit(main())
