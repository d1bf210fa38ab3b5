#!/usr/bin/env python3
"""Helper of make_esso_osaka_wind.sh: the JSON of `swayaw compare` with and without the measured wind as a table. Standard library only.

    esso_osaka_wind.py compared WITH.json WITHOUT.json    a row for each run, its name, and for all of them
    esso_osaka_wind.py diagnosed WITH.json WITHOUT.json   the same for two documents of `swayaw diagnose`"""
import json
import math
import sys

SHOWN = [("position", "window_rms", "m", 1.0), ("position", "open_loop_rms", "m", 1.0), ("speed", "window_rms", "m/s", 1.0),
         ("drift", "window_rms", "deg", 180.0 / math.pi), ("yaw_rate", "window_rms", "deg/s", 180.0 / math.pi)]
NAMES = ["position, windows [m]", "position, whole run [m]", "speed [m/s]", "drift [deg]", "yaw rate [deg/s]"]


def cells(with_wind, without):
    def value(quantities, name, key, factor):
        return next(q[key] * factor for q in quantities if q["quantity"] == name)
    return [f"{value(without, n, k, f):.3g} → {value(with_wind, n, k, f):.3g}" for n, k, _, f in SHOWN]


def compared(with_file, without_file):
    told, untold = (json.load(open(f, encoding="utf-8")) for f in (with_file, without_file))
    print("| run | used [s] | " + " | ".join(NAMES) + " |")
    print("| --- | ---: |" + " ---: |" * len(NAMES))
    for a, b in zip(told["runs"], untold["runs"], strict=True):
        name = a["run"].rsplit("/", 1)[-1].removesuffix(".csv").replace("_", " ")
        print(f"| {name} | {a['duration_s']:.0f} | " + " | ".join(cells(a["quantities"], b["quantities"])) + " |")
    both = cells(told["all_runs"]["quantities"], untold["all_runs"]["quantities"])
    print("| **all** | | " + " | ".join(both) + " |")


def diagnosed(with_file, without_file):
    print("| wind columns | verdict | effects | yaw rate off as given | coefficients moved |")
    print("| --- | --- | --- | ---: | ---: |")
    for how, path in (("ignored", without_file), ("used", with_file)):
        d = json.load(open(path, encoding="utf-8"))
        effects = ", ".join(f"`{e['effect']}`, probability {e['probability']:.3f}" for e in d["effects"]) or "–"
        off = d["discrepancy"]
        print(f"| {how} | {d['verdict']} | {effects} | {100 * off['given']:.0f} % | {100 * off['refitted']:.1f} % |")


if __name__ == "__main__":
    {"compared": compared, "diagnosed": diagnosed}[sys.argv[1]](*sys.argv[2:])
