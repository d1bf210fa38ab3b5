"""Runs the program on MV Nawigator XXI and writes the tables (Markdown) and figures (SVG) of kulbiej2021.md.

    compute.py PROGRAM PROJECT FOLDER_FOR_TABLES FOLDER_FOR_SVG

What the paper prints comes from tests/golden/kulbiej2021.json, everything else from the program.
"""
import csv
import json
import math
import re
import subprocess
import sys
from pathlib import Path

import matplotlib

matplotlib.use("svg")
import matplotlib.pyplot as plt

PROGRAM, PROJECT, TABLES, FIGURES = (Path(argument).resolve() for argument in sys.argv[1:5])
GOLDEN = json.loads((PROJECT / "tests/golden/kulbiej2021.json").read_text())
MEASURED = {int(rudder): row for rudder, row in GOLDEN["table2_measured"].items()}
PRINTED = GOLDEN["table5_simulated_printed"]
L, REV = 56.85, 3.7
INDICES = ["u_s m/s", "v_s m/s", "r_s rad/s", "D", "Ad", "Td"]
DIGITS = [3, 3, 4, 3, 3, 3]

plt.rcParams.update({
    "svg.hashsalt": "swayaw", "font.size": 9, "axes.grid": True, "grid.color": "#e4e4e4", "grid.linewidth": 0.6,
    "axes.spines.top": False, "axes.spines.right": False, "axes.axisbelow": True, "legend.frameon": False, "legend.fontsize": 8,
    "axes.titlesize": 9, "axes.titlelocation": "left",
})
COLOUR = {35: "#c8382a", 25: "#d98a00", 15: "#1f4e9c"}


# ---------------------------------------------------------------- ships and runs

def text_of(hull):
    return (PROJECT / "ships" / f"nawigator_{hull}.toml").read_text()


def number(text, key):
    return float(re.search(rf"^{key} = (\S+)$", text, re.M).group(1))


def with_number(text, key, value):
    return re.sub(rf"^{key} = .*$", f"{key} = {value!r}", text, flags=re.M)


def read_as(hull, surge):
    """The ship file with the surge equation read in one of three ways."""
    text = text_of(hull)
    size = abs(number(text, "X_vr"))
    text = with_number(text, "X_vr", -size if surge == "X_vr negative" else size)
    return text.replace("[hull]", 'surge_coupling = "m"\n\n[hull]') if surge == "m v r" else text


SURGES = ["as printed", "m v r", "X_vr negative"]
SHIPS = {(hull, surge): read_as(hull, surge) for hull in ("n7", "ym") for surge in SURGES}
NAME = {"n7": "N7", "ym": "YM"}


def run(text, *arguments):
    """The JSON of a command on a ship, and its time series if it has one."""
    ship, out = TABLES / "ship.toml", TABLES / "run.csv"
    ship.write_text(text)
    words = [str(out) if a == "OUT" else str(a) for a in arguments]
    document = json.loads(subprocess.run([PROGRAM, words[0], ship, *words[1:], "--json"], check=True, capture_output=True).stdout)
    if "OUT" not in arguments:
        return document
    with open(out, newline="") as file:
        rows = list(csv.DictReader(line for line in file if not line.startswith("#")))
    return document, {key: [float(row[key]) for row in rows] for key in rows[0]}


def turn(text, rudder):
    return run(text, "simulate", "--turn", rudder, "--rev", REV)


def indices(circle):
    """The six numbers of the paper; None for what does not exist."""
    U, beta, r = circle["final_speed_m_s"], circle["final_drift_rad"], circle["final_yaw_rate_rad_s"]
    steady = [None] * 4 if U is None else [U * math.cos(beta), -U * math.sin(beta), r, circle["final_diameter_m"] / L]
    return steady + [circle["advance_m"] / L, circle["tactical_diameter_m"] / L]


def errors(rows):
    """Sums of squares and of sizes of the relative differences; None if a turn is missing."""
    parts = [None if i is None else 1 - i / m for rudder, row in rows.items() for i, m in zip(row, MEASURED[rudder])]
    return (None, None) if None in parts else (sum(p * p for p in parts), sum(abs(p) for p in parts))


def zigzag(text, name, *more):
    side = "starboard" if name.endswith("S") else "port"
    return run(text, "simulate", "--zigzag", name[:-1], "--first", side, "--rev", REV, *more)


# ---------------------------------------------------------------- tables

def cell(value, digits):
    return "–" if value is None else f"{value:.{digits}f}"


def write(name, head, rows):
    lines = ["| " + " | ".join(head) + " |", "|" + " --- |" * len(head)]
    lines += ["| " + " | ".join(str(c) for c in row) + " |" for row in rows]
    (TABLES / f"{name}.md").write_text("\n".join(lines) + "\n")


def symbol(key):
    return key[0] + "_" + key[1:]


def table_labels():
    printed, right = GOLDEN["table_3_as_printed"], GOLDEN["table_3_labels_corrected"]
    rows = []
    for key in printed["YM"]:
        if printed["YM"][key] == right["YM"][key]:
            continue
        meant = next(k for k in right["YM"] if right["YM"][k] == printed["YM"][key] and right["N7"][k] == printed["N7"][key])
        rows.append([symbol(key), printed["N7"][key], printed["YM"][key], symbol(meant)])
    write("labels", ["printed name", "N7", "YM", "is"], rows)


def table_zigzags():
    rows, errors_of = [], {1: [], 2: [], 3: []}
    for name, printed in PRINTED.items():
        if name == "turn35":
            continue
        peaks = zigzag(SHIPS["n7", "as printed"], name)["overshoot_deg"][:4]
        for first in errors_of:
            errors_of[first] += [abs(p / q - 1) for p, q in zip(peaks[first - 1:first + 1], printed)]
        rows.append([f"{name[:-1]} {'starboard' if name[-1] == 'S' else 'port'} first", *printed, *(cell(p, 2) for p in peaks)])
    write("zigzags", ["zigzag", "printed 1st", "printed 2nd", "peak 1", "peak 2", "peak 3", "peak 4"], rows)
    write("zigzag_errors", ["printed 1st and 2nd are", "mean difference"],
          [[f"peaks {first} and {first + 1}", f"{100 * sum(e) / len(e):.1f} %"] for first, e in errors_of.items()])


def table_turns(all_turns):
    row_of = lambda name, row: [name, *(cell(i, d) for i, d in zip(row, DIGITS))]
    p = PRINTED["turn35"]
    rows = [["measured (table 2)", *MEASURED[35]], ["simulated, printed (table 5)", p["us"], p["vs"], p["rs"], p["D"], p["Ad"], p["Td"]]]
    rows += [row_of(f"{NAME[hull]}, {surge}", turns[35]) for (hull, surge), turns in all_turns.items()]
    write("turn35", ["35 deg to starboard", *INDICES], rows)
    rows = []
    for rudder in MEASURED:
        rows.append([f"{rudder} deg, measured", *MEASURED[rudder]])
        rows += [row_of(f"{rudder} deg, {NAME[hull]}, {surge}", all_turns[hull, surge][rudder]) for hull, surge in (("ym", "X_vr negative"), ("n7", "m v r"))]
    write("measured", ["turn", *INDICES], rows)
    rows = [["initial set, claimed", "4.273", ""], ["N7, claimed", "1.348", ""]]
    for (hull, surge), turns in all_turns.items():
        squares, sizes = errors(turns)
        rows.append([f"{NAME[hull]}, {surge}", cell(squares, 4) if squares is not None else "no steady turn at 35 deg", cell(sizes, 3)])
    write("errors", ["hull set and surge equation", "sum of squares", "sum of sizes"], rows)


def table_sensitivity():
    text = SHIPS["ym", "X_vr negative"]
    base, rows = indices(turn(text, 35)), []
    for key in GOLDEN["table_3_as_printed"]["YM"]:
        changed = indices(turn(with_number(text, symbol(key), 1.1 * number(text, symbol(key))), 35))
        rows.append([symbol(key), *(100 * (i / b - 1) for i, b in zip(changed, base))])
    rows.sort(key=lambda row: -max(abs(x) for x in row[1:]))
    write("sensitivity", ["+10 % of", "u_s", "v_s", "r_s", "D", "Ad", "Td"], [[row[0], *(f"{x:+.2f}" for x in row[1:])] for row in rows])


def table_linear():
    rows = []
    for hull in ("n7", "ym"):
        for side in ("starboard", "port"):
            i = run(SHIPS[hull, "as printed"], "linearize", "--rev", REV, "--side", side)
            rows.append([f"{NAME[hull]}, {side}", *(f"{i[k]:.4f}" for k in ("a1", "b1", "c1", "a2", "b2", "c2", "T1", "T2", "T3b", "T3w", "Kb", "Kw"))])
    write("linear", ["straight ahead, turning to", "a1", "b1", "c1", "a2", "b2", "c2", "T1", "T2", "T3b", "T3w", "Kb", "Kw"], rows)


def residual(hull, u, v, r):
    """Sway balance without rudder and propeller over 0.5 rho L d U^2 (tests/nonlinear/nawigator_test.cpp tells the formula)."""
    text = SHIPS[hull, "as printed"]
    force = run(text, "forces", "--state", f"u={u},v={v},r={r},delta=0,rev={REV}")["parts"]["hull"]
    rho, d, a_H = number(text, "density_kg_m3"), number(text, "draught_m"), number(text, "a_H")
    x_R = float(re.search(r"^\[rudder\].*?^x_prime = (\S+)$", text, re.M | re.S).group(1))
    lever = L * (x_R + a_H * number(text, "x_H_prime")) / (1 + a_H)
    mass_x = rho * number(text, "displacement_m3") + 0.5 * rho * L * L * d * number(text, "m_x")
    return (force["Y"] - mass_x * u * r - force["N"] / lever) / (0.5 * rho * L * d * (u * u + v * v))


def table_residual():
    p, steps = PRINTED["turn35"], (-1, -0.5, 0, 0.5, 1)
    rows = []
    for hull in ("n7", "ym"):
        box = [residual(hull, p["us"] + 0.005 * i, p["vs"] + 0.005 * j, p["rs"] + 0.0005 * k) for i in steps for j in steps for k in steps]
        rows.append([NAME[hull], f"{residual(hull, p['us'], p['vs'], p['rs']):+.4f}", f"{min(box):+.4f} … {max(box):+.4f}"])
    write("residual", ["hull set", "left of the sway balance", "over all motions that round to it"], rows)


# ---------------------------------------------------------------- tuning

INDICES_OF = PROJECT / "examples/indices"


def tuned(indices, prior=1):
    """The document of a tuning from YM with X_vr negative, and the text of the ship it made."""
    out = TABLES / "tuned.toml"
    document = run(SHIPS["ym", "X_vr negative"], "tune", "--indices", indices, "--prior", prior, "--bound", 1, "--out", out)
    return document, out.read_text()


def with_zigzags(printed):
    """The measured turns, and zigzags whose overshoots count from the second peak."""
    text = (INDICES_OF / "nawigator_turns.toml").read_text()
    for name, row in printed.items():
        rudder, heading = name[:-1].split("/")
        text += f'[[zigzag]]\nrudder_deg = {rudder}\nheading_deg = {heading}\nfirst = "{"starboard" if name[-1] == "S" else "port"}"\n'
        text += f"first_peak = 2\novershoot_deg = {row}\n"
    file = TABLES / "indices.toml"
    file.write_text(text)
    return file


def zigzag_error(text, printed):
    """Sum of squares against the second and third heading peak; None if one is missing."""
    parts = []
    for name, numbers in printed.items():
        peaks = zigzag(text, name)["overshoot_deg"][1:3]
        parts += [1 - p / q for p, q in zip(peaks, numbers)]
    return sum(p * p for p in parts) if len(parts) == 2 * len(printed) else None


def table_tuning(all_turns):
    measured = {"10/20S": [19, 19]}
    simulated = {name: row for name, row in PRINTED.items() if name[:5] in ("10/10", "20/20")}
    by_turns, turns_text = tuned(INDICES_OF / "nawigator_turns.toml")
    by_both, both_text = tuned(INDICES_OF / "nawigator.toml")
    by_simulated, simulated_text = tuned(with_zigzags(simulated), 0.5)
    sets = [("YM, X_vr negative: the start", SHIPS["ym", "X_vr negative"], errors(all_turns["ym", "X_vr negative"])[0], "–"),
            ("N7, m v r", SHIPS["n7", "m v r"], errors(all_turns["n7", "m v r"])[0], "up to 4.1 million for five numbers"),
            ("tuned on the turns", turns_text, by_turns["error"]["turns"]["after"], by_turns["voyages"]["turns"]),
            ("tuned on the turns and the measured zigzag", both_text, by_both["error"]["turns"]["after"], by_both["voyages"]["turns"]),
            ("tuned on the turns and the simulated zigzags, prior 50 %", simulated_text, by_simulated["error"]["turns"]["after"], by_simulated["voyages"]["turns"])]
    rows = [[name, cell(turns, 4), cell(zigzag_error(text, measured), 3), cell(zigzag_error(text, simulated), 3), count] for name, text, turns, count in sets]
    write("tuning", ["hull set", "18 indices of the turns", "measured zigzag", "simulated zigzags", "turning circles sailed"], rows)
    rows = []
    for a, b in zip(by_turns["numbers"], by_both["numbers"]):
        n7 = number(SHIPS["n7", "X_vr negative"], a["name"])
        rows.append([a["name"], a["before"], n7, f"{a['after']:.4f}", f"{b['after']:.4f}", f"{100 * a['told']:.0f} %", f"{100 * a['standard_error']:.0f} %"])
    write("tuned_numbers", ["derivative", "YM", "N7", "tuned on the turns", "on turns and zigzag", "told by the turns", "standard error"], rows)
    rows = []
    for index_a, index_b in zip(by_turns["indices"], by_both["indices"]):
        rows.append([index_a["manoeuvre"], index_a["index"], *(f"{x:.4g}" for x in (index_a["measured"], index_a["before"], index_a["after"], index_b["after"]))])
    for index in by_both["indices"][len(by_turns["indices"]):]:
        rows.append([index["manoeuvre"], index["index"], f"{index['measured']:.4g}", f"{index['before']:.4g}", "", f"{index['after']:.4g}"])
    write("tuned_indices", ["manoeuvre", "index", "measured", "YM", "tuned on the turns", "on turns and zigzag"], rows)
    values = by_turns["relative_singular_values"]
    write("singular_values", [str(i + 1) for i in range(9)], [[f"{v:.2g}" for v in values[:9]]])


# ---------------------------------------------------------------- figures

def save(figure, name):
    figure.tight_layout()
    figure.savefig(FIGURES / f"{name}.svg", metadata={"Date": None, "Creator": None})
    plt.close(figure)


def figure_turns():
    figure, panels = plt.subplots(1, 2, figsize=(8.6, 5.0), sharex=True, sharey=True)
    for axes, (hull, surge) in zip(panels, (("ym", "X_vr negative"), ("n7", "m v r"))):
        for rudder, row in MEASURED.items():
            _, track = run(SHIPS[hull, surge], "simulate", "--turn", rudder, "--rev", REV, "--duration", 260, "--out", "OUT")
            axes.plot([y / L for y in track["y_m"]], [x / L for x in track["x_m"]], color=COLOUR[rudder], linewidth=1.4, label=f"{rudder} deg")
            axes.plot([0.0, row[5]], [row[4]] * 2, color=COLOUR[rudder], linewidth=0.9, linestyle=(0, (5, 3)))
            axes.plot([row[5]] * 2, [0.0, row[4]], color=COLOUR[rudder], linewidth=0.9, linestyle=(0, (1.5, 2)))
        axes.set_title(f"{NAME[hull]}, {surge}")
        axes.set_aspect("equal")
        axes.set_xlabel("y / L")
    panels[0].set_ylabel("x / L")
    panels[0].legend(loc="lower left")
    save(figure, "turns")


def figure_zigzags():
    names = [name for name in PRINTED if name != "turn35"]
    figure, panels = plt.subplots(3, 2, figsize=(8.6, 7.6))
    for axes, name in zip(panels.flat, names):
        document, track = zigzag(SHIPS["n7", "as printed"], name, "--duration", 240, "--out", "OUT")
        time = [t * 5.91 / L for t in track["time_s"]]
        heading = [math.degrees(psi) for psi in track["psi_rad"]]
        axes.plot(time, heading, color="#1f4e9c", label="heading, N7 as printed")
        axes.plot(time, [-math.degrees(d) for d in track["delta_rad"]], color="#888888", linewidth=0.9, label="rudder, to starboard")
        switch = float(name[:-1].split("/")[1])
        for peak, printed in zip(document["peak_s"][1:3], PRINTED[name]):
            at = min(range(len(heading)), key=lambda i: abs(track["time_s"][i] - peak))
            t = peak * 5.91 / L
            axes.plot([t - 1.2, t + 1.2], [math.copysign(switch + printed, heading[at])] * 2, color="#c8382a", linewidth=1.6,
                      label="printed overshoot" if printed is PRINTED[name][0] else None)
        axes.set_title(f"{name[:-1]}, {'starboard' if name[-1] == 'S' else 'port'} first")
        axes.set_ylabel("deg")
        axes.set_xlabel("t U_0 / L")
    handles, labels = panels.flat[0].get_legend_handles_labels()
    panels.flat[-1].axis("off")
    panels.flat[-1].legend(handles, labels, loc="center")
    save(figure, "zigzags")


if __name__ == "__main__":
    turns = {key: {rudder: indices(turn(text, rudder)) for rudder in MEASURED} for key, text in SHIPS.items()}
    table_labels()
    table_zigzags()
    table_turns(turns)
    table_sensitivity()
    table_linear()
    table_residual()
    table_tuning(turns)
    figure_turns()
    figure_zigzags()
