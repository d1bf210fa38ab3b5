"""Draws figures 1 to 9 from the CSV files of example_linear_figures.

    draw.py FOLDER_WITH_CSV FOLDER_FOR_SVG

The files come out the same every time: fixed ids, no date.
"""
import csv
import sys
from collections import defaultdict
from pathlib import Path

import matplotlib

matplotlib.use("svg")
import matplotlib.pyplot as plt

plt.rcParams.update({
    "svg.hashsalt": "swayaw", "font.size": 9, "axes.grid": True, "grid.color": "#e4e4e4", "grid.linewidth": 0.6,
    "axes.spines.top": False, "axes.spines.right": False, "axes.axisbelow": True, "legend.frameon": False, "legend.fontsize": 8,
    "legend.handlelength": 2.6, "axes.titlesize": 9, "axes.titlelocation": "left",
})

COLOUR = {"REF": "#1f4e9c", "2.5 deg/s": "#1f4e9c", "0.5 deg/s": "#7a3fa0", "T3b = 0.309": "#2c8a4b", "T3w = 0.492": "#c8382a",
          "T3w = 1.966": "#d98a00", "1st ORD, delta = const": "#11b5c9", "1st ORD, delta = var": "#8a5a2b"}
AXIS = {"s": "s'  [ship lengths]", "psi_deg": "psi  [deg]", "delta_deg": "delta  [deg]", "beta_deg": "beta  [deg]", "omega": "omega'",
        "dbeta_ds_deg": "d(beta)/ds'  [deg]", "domega_ds": "d(omega')/ds'"}


def read(path):
    curves = defaultdict(lambda: defaultdict(list))
    with open(path, newline="") as file:
        for row in csv.DictReader(file):
            name = row.pop("curve")
            for key, value in row.items():
                curves[name][key].append(float(value))
    return curves


def style(name):
    base = name.removesuffix(", exact").removesuffix(", Euler")
    if name.endswith("Euler"):
        return {"color": COLOUR[base], "linewidth": 1.0, "linestyle": (0, (3, 2)), "alpha": 0.75}
    if name.startswith("1st ORD"):
        return {"color": COLOUR[base], "linewidth": 1.4, "linestyle": (0, (7, 4)) if "const" in name else "solid", "zorder": 4 if "const" in name else 3}
    return {"color": COLOUR[base], "linewidth": 1.7}


def draw(axes, curves, x, y, only=None):
    for name, columns in curves.items():
        if only is None or only(name):
            axes.plot(columns[x], columns[y], label=name, **style(name))
    axes.set_xlabel(AXIS[x])
    axes.set_ylabel(AXIS[y])


def over_time(curves, rows, end, skip=()):
    """One panel for each quantity above a common time axis."""
    figure, panels = plt.subplots(len(rows), 1, figsize=(7.2, 2.5 * len(rows) + 0.5), sharex=True)
    for axes, quantity in zip(panels, rows):
        draw(axes, curves, "s", quantity, lambda name: (quantity, name.split(",")[0]) not in skip)
        axes.set_xlim(0, end)
        axes.axhline(0, color="#888888", linewidth=0.7)
    for axes in panels[:-1]:
        axes.set_xlabel("")
    legend(figure, panels[0])
    return figure


def plane(curves):
    """Drift and yaw rate; the part under the first-order curve is enlarged beside it."""
    figure, panels = plt.subplots(1, 2, figsize=(8.6, 4.3), width_ratios=[1.25, 1])
    for axes in panels:
        draw(axes, curves, "beta_deg", "omega")
        axes.axhline(0, color="#888888", linewidth=0.7)
        axes.axvline(0, color="#888888", linewidth=0.7)
    panels[0].set_xlim(-16, 16)
    panels[0].set_ylim(-0.4, 0.4)
    panels[1].set_xlim(0, 8)
    panels[1].set_ylim(0, 0.26)
    panels[1].set_title("first quadrant")
    panels[1].set_ylabel("")
    legend(figure, panels[0])
    return figure


def legend(figure, axes):
    """Above the panels, which get the rest of the sheet."""
    handles, labels = axes.get_legend_handles_labels()
    columns = len(labels) if len(labels) < 4 else (len(labels) + 1) // 2
    rows = -(-len(labels) // columns)
    figure.tight_layout(rect=(0, 0, 1, 1 - (0.08 + 0.2 * rows) / figure.get_figheight()))
    figure.legend(handles, labels, loc="upper center", ncols=columns)


def figures(folder):
    c = {n: read(folder / f"figure_{n}.csv") for n in range(1, 10)}
    heading, motion, slopes = ["psi_deg", "delta_deg"], ["beta_deg", "omega"], ["dbeta_ds_deg", "domega_ds"]
    yield 1, over_time(c[1], heading, 25)
    yield 2, over_time(c[2], motion, 25)
    yield 3, plane(c[3])
    yield 4, plane(c[4])
    yield 5, over_time(c[5], slopes, 10)
    yield 6, over_time(c[6], slopes, 15)
    yield 7, over_time(c[7], heading, 25)
    yield 8, over_time(c[8], slopes, 10)
    figure, axes = plt.subplots(figsize=(7.2, 3.4))
    draw(axes, c[9], "s", "beta_deg")
    axes.set_xlim(0, 25)
    axes.axhline(0, color="#888888", linewidth=0.7)
    legend(figure, axes)
    yield 9, figure


if __name__ == "__main__":
    source, target = Path(sys.argv[1]), Path(sys.argv[2])
    for number, figure in figures(source):
        figure.savefig(target / f"figure_{number}.svg", metadata={"Date": None, "Creator": None})
        plt.close(figure)
