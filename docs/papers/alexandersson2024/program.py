"""The program from the outside, for the tables of alexandersson2024.md."""
import csv
import json
import re
import subprocess
from math import sqrt

import numpy as np


def rms(x):
    x = np.asarray(x, dtype=float)
    return sqrt(float(np.mean(x * x)))


def table(head, rows, align):
    """Markdown; `align` tells l or r of every column but the first."""
    count = head.count("|") + 1
    marks = ["---"] + ["---:" if a == "r" else "---" for a in align]
    assert len(marks) == count and all(len(row) == count for row in rows), head
    lines = [f"| {head} |", "| " + " | ".join(marks) + " |", *("| " + " | ".join(map(str, row)) + " |" for row in rows)]
    return "\n".join(lines) + "\n"


class Program:
    def __init__(self, program, project, folder):
        self.program, self.project, self.folder = program, project, folder
        self.variants, self.known = {}, {}

    def run(self, *words):
        return subprocess.run([self.program, *map(str, words)], capture_output=True, text=True, check=True).stdout

    def json(self, *words):
        return json.loads(self.run(*words, "--json"))

    def golden(self, name):
        return json.loads((self.project / "tests" / "golden" / f"{name}.json").read_text())

    # ------------------------------------------------------------ ships

    def ship(self, name):
        return self.variants.get(name, self.project / "ships" / f"{name}.toml")

    def number(self, ship, key, index=None):
        value = re.search(rf"^{key} = (.*?)(?:#.*)?$", self.ship(ship).read_text(), re.MULTILINE).group(1).strip()
        return float(value) if index is None else float(value.strip("[]").split(",")[index])

    def number_in(self, ship, section, key):
        """Where two sections have that key."""
        return float(re.search(rf"^\[{section}\].*?^{key} = ([-+.\de]+)", self.ship(ship).read_text(), re.MULTILINE | re.DOTALL).group(1))

    def variant(self, ship, name, **values):
        """The ship with other values; section__key where two sections have that key or none has."""
        text = self.ship(ship).read_text()
        for path, value in values.items():
            section, key = path.split("__") if "__" in path else (None, path)
            start = re.search(rf"^\[{section}\].*\n", text, re.MULTILINE).end() if section else 0
            head, rest = text[:start], text[start:]
            rest, count = re.subn(rf"^{key} = .*$", f"{key} = {value}", rest, count=1, flags=re.MULTILINE)
            text = head + (rest if count else f"{key} = {value}\n{rest}")
            assert count or section, f"{key} is not in {ship}"
        file = self.folder / f"{name}.toml"
        file.write_text(text)
        self.variants[name] = file
        return name

    # ------------------------------------------------------------ what the program says

    def forces(self, ship, **state):
        key = (ship, tuple(state.items()))
        if key not in self.known:
            self.known[key] = self.json("forces", self.ship(ship), "--state", ",".join(f"{k}={float(x)!r}" for k, x in state.items()))
        return self.known[key]

    @staticmethod
    def sum(forces, *parts):
        return {axis: sum(forces["parts"][part][axis] for part in parts if part in forces["parts"]) for axis in "XYN"}

    @staticmethod
    def recording(file):
        with open(file, newline="") as lines:
            rows = list(csv.DictReader(line for line in lines if not line.startswith("#")))
        return {name: np.array([float(row[name] or "nan") for row in rows]) for name in rows[0]}
