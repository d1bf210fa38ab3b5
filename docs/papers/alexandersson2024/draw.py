"""Draws the figures of alexandersson2024.md from the curves of tables.py.

    draw.py CURVES_JSON FOLDER_FOR_SVG

The files come out the same every time: fixed ids, no date.
"""
import json
import sys
from pathlib import Path

import matplotlib

matplotlib.use("svg")
import matplotlib.pyplot as plt

plt.rcParams.update({
    "svg.hashsalt": "swayaw", "font.size": 9, "axes.grid": True, "grid.color": "#e4e4e4", "grid.linewidth": 0.6,
    "axes.spines.top": False, "axes.spines.right": False, "axes.axisbelow": True, "legend.frameon": False, "legend.fontsize": 8,
    "axes.titlesize": 9, "axes.titlelocation": "left",
})

COLOUR = {"Reference": "#1f4e9c", "PI": "#2c8a4b", "PU": "#c8382a"}
LABEL = {"psi_deg": "psi  [deg]", "beta_deg": "beta  [deg]", "r": "r  [rad/s]"}


def above(figure, axes, columns):
    """The legend, with the rest of the sheet for the panels."""
    handles, labels = axes.get_legend_handles_labels()
    rows = -(-len(labels) // columns)
    figure.tight_layout(rect=(0, 0, 1, 1 - (0.14 + 0.2 * rows) / figure.get_figheight()))
    figure.legend(handles, labels, loc="upper center", ncols=columns)


def figure_9(c):
    figure, panels = plt.subplots(2, 4, figsize=(9.2, 4.8), sharex="col")
    for column, (name, d) in zip(panels.T, c.items()):
        for axes, axis in zip(column, "YN"):
            for part, colour, label in (("D", "#c8382a", "total"), ("H", "#2c8a4b", "hull"), ("R", "#1f4e9c", "rudder")):
                key = f"{axis}_{part}"
                axes.plot(d["x"], d["ours"][key], color=colour, linewidth=1.3, label=f"{label}, swayaw")
                axes.plot(d["x"], d["markers"][key], "+", color=colour, markersize=8, label=f"{label}, marker of the paper")
                axes.plot(d["x"], d["vct"][key], "o", color=colour, markersize=3.5, markerfacecolor="none", label=f"{label}, virtual test")
        column[0].set_title(name)
        column[1].set_xlabel({"Circle": "r'", "Drift angle": "beta  [deg]", "Rudder angle": "delta  [deg]", "Thrust variation": "T over self-propulsion"}[name])
    panels[0][0].set_ylabel("Y' × 1000")
    panels[1][0].set_ylabel("N' × 1000")
    above(figure, panels[0][0], 3)
    return figure


def figure_10(c):
    figure, panels = plt.subplots(3, 2, figsize=(9.2, 7.2), sharex="col")
    for column, (name, d) in zip(panels.T, c.items()):
        for axes, quantity in zip(column, LABEL):
            axes.plot(*d["test"][quantity], color="black", linewidth=1.6, label="test")
            for model, colour in COLOUR.items():
                axes.plot(d[model]["time"], d[model][quantity], color=colour, linewidth=1.3, label=f"{model}, swayaw")
                axes.plot(*d[model]["paper"][quantity], ".", color=colour, markersize=3, label=f"{model}, curve of the paper")
            axes.set_xlim(0, d["test"]["psi_deg"][0][-1])
            axes.set_ylabel(LABEL[quantity])
        column[0].set_title(f"{name}, first to port")
        column[-1].set_xlabel("t  [s]")
    above(figure, panels[0][0], 4)
    return figure


def figure_11(c):
    rows = {"Y_D": "Y_D  [N]", "N_D": "N_D  [N m]", "N_H": "N_H  [N m]", "N_R": "N_R + N_RHI  [N m]"}
    figure, panels = plt.subplots(4, 2, figsize=(9.2, 8.2), sharex="col")
    for column, (name, d) in zip(panels.T, c.items()):
        for axes, (key, label) in zip(column, rows.items()):
            for model, colour in COLOUR.items():
                axes.plot(d["time"], d[model][key], color=colour, linewidth=1.3, label=model, linestyle="dashed" if model == "PI" else "solid")
            axes.set_ylabel(label)
        column[0].set_title(f"at the states of the {name} test")
        column[-1].set_xlabel("t  [s]")
    above(figure, panels[0][0], 3)
    return figure


def figure_13(c):
    rows = {"N_v": "N_H of drift  [N m]", "N_r": "N_H of yaw  [N m]", "Y_v": "Y_H of drift  [N]"}
    d = c["20/20"]
    figure, panels = plt.subplots(1, 3, figsize=(9.2, 2.9))
    for axes, (key, label) in zip(panels, rows.items()):
        for model, colour in COLOUR.items():
            axes.plot(d["time"], d[model][key], color=colour, linewidth=1.3, label=model, linestyle="dashed" if model == "PI" else "solid")
        axes.set_ylabel(label)
        axes.set_xlabel("t  [s]")
    above(figure, panels[0], 3)
    return figure


def figure_14(c):
    figure, panels = plt.subplots(1, 3, figsize=(9.2, 3.2), width_ratios=[1, 1, 1.15])
    for axes, axis, label in zip(panels, "YN", ("Y_D  [N]", "N_D  [N m]")):
        for model, colour in COLOUR.items():
            axes.plot(c["beta_deg"], c[model][axis], color=colour, linewidth=1.4, label=model)
        axes.set_xlabel("beta  [deg]")
        axes.set_ylabel(label)
    parts = [("hull", "#9db7dd"), ("rudder", "#e0a458"), ("rudder_hull_interaction", "#8a5a2b")]
    for i, model in enumerate(COLOUR):
        start = {1: 0.0, -1: 0.0}
        for part, colour in parts:
            N = c[model]["parts"].get(part, {"N": 0.0})["N"]
            side = 1 if N >= 0.0 else -1
            panels[2].bar(i, N, 0.55, bottom=start[side], color=colour, label=part.replace("_", " ") if i == 0 else None)
            start[side] += N
        panels[2].plot([i - 0.4, i + 0.4], [c[model]["N"][-1]] * 2, color="black", linewidth=1.4, label="sum" if i == 0 else None)
    panels[2].set_xticks(range(3), COLOUR)
    panels[2].set_ylabel("N at 10 deg  [N m]")
    panels[2].axhline(0, color="#888888", linewidth=0.7)
    panels[2].set_ylim(top=44)
    panels[2].legend(loc="upper right", ncols=2)
    above(figure, panels[0], 3)
    return figure


if __name__ == "__main__":
    curves, target = json.loads(Path(sys.argv[1]).read_text()), Path(sys.argv[2])
    drawn = {"9": figure_9(curves["figure 9"]), "10": figure_10(curves["figure 10"]), "11": figure_11(curves["figure 11"]),
             "13": figure_13(curves["figure 11"]), "14": figure_14(curves["figure 14"])}
    for number, figure in drawn.items():
        figure.savefig(target / f"figure_{number}.svg", metadata={"Date": None, "Creator": None})
        plt.close(figure)
