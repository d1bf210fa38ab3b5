# %% [markdown]
# # The wind on a pond, found without an anemometer
#
# **Question.** A model of a ship is trusted, and her recordings disagree with it. Is the model wrong, or was there something on the water that nobody wrote down?
#
# The 3 m model of the Esso Osaka was sailed on the Inukai pond of Osaka University in 2020, seven turns on one day and seven zigzags on another (data set FRT-DS-ESSO, CC BY-NC 4.0; Wakita et al. 2022, Miyauchi et al. 2022). The wind was measured. Here its
# columns are taken out, and the diagnosis is asked what the published model lacks. The recordings are not part of swayaw: the variable `SWAYAW_RECORDINGS` names the folder that has them in `esso_osaka/`.

# %%
import math
import os
import pathlib
import re

import matplotlib.pyplot as plt
import numpy
import pandas

import swayaw

folder = pathlib.Path(os.environ.get("SWAYAW_RECORDINGS", "recordings")) / "esso_osaka"
if not folder.is_dir():
    raise SystemExit(f"{folder}: the recordings of the Esso Osaka are not there; SWAYAW_RECORDINGS tells the folder")

ship = swayaw.published_ship("esso_osaka_3m")
wind_columns = ["wind_speed_m_s", "wind_from_rad"]
files = sorted([*folder.glob("turn_*.csv"), *folder.glob("zigzag_*.csv")])


def with_way(run):
    """The longest stretch with the propeller ahead and u above 0.08 m/s: rows of the table of the recording."""
    ahead = (run["rev_s"] > 0.0) & (run["u_m_s"] > 0.08)
    edges = numpy.flatnonzero(numpy.diff(ahead, prepend=False, append=False))
    begin, end = max(zip(edges[::2], edges[1::2]), key=lambda stretch: stretch[1] - stretch[0])
    return run.to_dataframe()[begin:end]


def force_of(table):
    """The steady wind with the same mean of V², as a complex number: north and i times east [m²/s²]."""
    return numpy.mean(table["wind_speed_m_s"] ** 2 * numpy.exp(1j * table["wind_from_rad"]))


tables = {file.stem: with_way(swayaw.read_csv(file)) for file in files}
day_of = {name: re.search(r"\d+-[A-Z][a-z]+-\d+", name).group() for name in tables}
measured = {
    day: numpy.mean([force_of(table) for name, table in tables.items() if day_of[name] == day])
    for day in sorted(set(day_of.values()))
}
figure, (left, right) = plt.subplots(ncols=2, figsize=(9.5, 4.2), layout="constrained")
for axes, name in ((left, "turn_14-Sep-2020_15_58_08"), (right, "zigzag_31-Jul-2020_13_22_52")):
    run = swayaw.Recording.from_dataframe(tables[name][::10])
    swayaw.figures.track(run, axes, label="recorded")
    calm = swayaw.Recording.from_dataframe(tables[name].drop(columns=wind_columns)[::10])
    swayaw.figures.track(swayaw.replay(ship, calm), axes, label="published model, calm")
    axes.set(title=name.split("_")[0] + " of " + day_of[name])
right.legend(fontsize="small", loc="lower right");

# %% [markdown]
# ## What is missing
#
# The runs go in without their wind, every fifth sample of the ten in a second, each day a group of its own. The diagnosis moves the coefficients within what is known of them, tries the known effects one at a time, and takes one if the evidence of all runs together asks for it.
# It takes half a minute here; with every sample and a search for more than one effect some minutes ([results](../results/esso_osaka_diagnosis.md)).

# %%
def without_wind(name):
    run = swayaw.Recording.from_dataframe(tables[name].drop(columns=wind_columns)[::5])
    run.name, run.remarks = name, {"group": f'"{day_of[name]}"'}
    return run


result = swayaw.diagnose(ship, [without_wind(name) for name in tables], most_effects=1, progress=False)
print(result.words)

# %%
best = result.candidates[:5]
figure, axes = plt.subplots(figsize=(6.5, 2.6), layout="constrained")
axes.barh([c.effect.replace("_", " ") for c in best], [c.log_evidence_gain for c in best])
axes.invert_yaxis()
axes.set(xlabel="gain of log evidence")
axes.axvline(0.0, color="0.4", linewidth=0.8);

# %% [markdown]
# ## The wind of each day, beside the anemometer

# %%
rows = []
in_degrees = lambda p: f"{math.degrees(p.value) % 360:.0f} ± {math.degrees(p.standard_error):.0f}"
for found in result.surroundings:
    wind = {p.key: p for p in found.parameters}
    speed, direction = wind["wind_speed_m_s"], wind["wind_from_rad"]
    anemometer = measured[found.scope]
    off = math.remainder(direction.value - numpy.angle(anemometer), math.tau)
    rows.append(
        {
            "day": found.scope,
            "found, m/s": f"{speed.value:.2f} ± {speed.standard_error:.2f}",
            "measured, m/s": math.sqrt(abs(anemometer)),
            "found from, deg": in_degrees(direction),
            "measured from, deg": math.degrees(numpy.angle(anemometer)) % 360,
            "speed off, %": 100.0 * (speed.value / math.sqrt(abs(anemometer)) - 1.0),
            "direction off, deg": math.degrees(off),
        }
    )
winds = pandas.DataFrame(rows).set_index("day")
winds

# %%
figure = plt.figure(figsize=(4.6, 4.6), layout="constrained")
axes = figure.add_subplot(projection="polar")
axes.set(theta_zero_location="N", theta_direction=-1)
for found, colour in zip(result.surroundings, ("C0", "C1")):
    wind = {p.key: p for p in found.parameters}
    speed, direction = wind["wind_speed_m_s"], wind["wind_from_rad"]
    axes.errorbar(
        direction.value, speed.value, xerr=direction.standard_error, yerr=speed.standard_error, fmt="o", color=colour,
        label=f"{found.scope}, found",
    )
    anemometer = measured[found.scope]
    axes.plot(numpy.angle(anemometer), math.sqrt(abs(anemometer)), "x", color=colour, markersize=10, label="measured")
axes.set_rmax(3.0)
axes.legend(fontsize="small", loc="lower left", bbox_to_anchor=(-0.15, -0.15));

# %% [markdown]
# **What it means.** There was wind, and fourteen runs tell from where and how strong, each day within 20 deg and 10 per cent; no other effect comes near. Two days with winds from opposite sides do that together: what the hull does is the same on both, what
# the wind does is not.
#
# **What the data cannot tell.** One day alone is worse: the turns by themselves are off by 30 deg, and waves explain them nearly as well. A steady wind has no gusts. And the wind is not all: more than half of the error of the yaw rate stays, and most of the
# missing force is of the form of the hull, which moved coefficients do not mend.
#
# More: [the wind hidden](../results/esso_osaka_diagnosis.md), [the wind used](../results/esso_osaka_wind.md), [diagnosis](../diagnose.md).

# %%
# Findings, as the text says them.
assert result.verdict == "missing_physics" and [e.effect.id for e in result.effects] == ["steady_wind"]
assert result.candidates[0].log_evidence_gain > 5 * max(c.log_evidence_gain for c in result.candidates[1:])
assert list(winds.index) == list(measured)
assert (winds["direction off, deg"].abs() < 20).all() and (winds["speed off, %"].abs() < 10).all()
