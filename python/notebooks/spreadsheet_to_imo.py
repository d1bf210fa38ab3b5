# %% [markdown]
# # From an Excel export to a verdict by IMO
#
# **Question.** A yard has sailed the steering trials of a tanker in one day. What comes home is one CSV file that somebody saved from Excel: German names, semicolons, decimal commas, clock times, a title above the
# names. Does the ship meet the steering criteria of MSC.137(76), and how sure is that?
#
# The file is made here from a simulated KVLCC2 in a current, so that the truth is known at the end.
#
# ## The day of trials
#
# A helmsman in ten lines: he keeps a course, or he sails a manoeuvre and looks at the compass once a second.

# %%
import datetime
import math
import pathlib

import matplotlib.pyplot as plt
import numpy
import pandas

import swayaw

ship = swayaw.published_ship("kvlcc2")
at_sea = swayaw.Simulator(ship)
at_sea.set_current(0.6, math.radians(200))
log = []


def sail(order, until):
    """Second by second, with the rudder that `order` tells [rad to port], until `until` says so."""
    while not until():
        at_sea.order_rudder(order())
        state = at_sea.state
        log.append((at_sea.time, state.x, state.y, state.psi, state.motion.r, at_sea.rudder, state.motion.u))
        at_sea.step(1.0)


def approach(course, seconds):
    """Keeps a course with small rudder angles."""
    end = at_sea.time + seconds
    helm = lambda: numpy.clip(2.0 * (at_sea.state.psi - course) + 60.0 * at_sea.state.motion.r, -0.12, 0.12)
    sail(helm, lambda: at_sea.time >= end)


def zigzag(angle, side):
    """Rudder and heading by the same angle, four reversals; side +1 is first to starboard."""
    course = at_sea.state.psi
    for leg in range(5):
        sign = side * (-1) ** leg
        sail(lambda: -sign * angle, lambda: sign * (at_sea.state.psi - course) >= angle)


def turn(angle, side):
    """A turn by 600 deg."""
    course = at_sea.state.psi
    sail(lambda: -side * angle, lambda: abs(at_sea.state.psi - course) >= math.radians(600))
    approach(math.pi * round(at_sea.state.psi / math.pi), 1500)


approach(0.0, 180)
for angle, side in ((10, 1), (10, -1), (20, 1)):
    zigzag(math.radians(angle), side)
    approach(0.0, 1500)
turn(math.radians(35), 1)
turn(math.radians(35), -1)
print(f"{len(log)} seconds at sea")

# %% [markdown]
# ## What comes home
#
# Instruments add noise and round, the rate gyro shows 0.9 deg/min at rest, the log drops out now and then, and Excel does the rest. That rudder angles count to starboard is known to everybody on board and
# written nowhere. The file is `Probefahrt.csv`, in the folder in which this runs.

# %%
time, x, y, psi, r, delta, u = numpy.array(log).T
rng = numpy.random.default_rng(7)
noisy = lambda values, deviation: values + deviation * rng.standard_normal(len(time))
comma = lambda values, digits: [f"{value:.{digits}f}".replace(".", ",") for value in values]
begin = datetime.datetime(2024, 5, 14, 9, 30)
clock = [begin + datetime.timedelta(seconds=round(t)) for t in time]
earth = 6371000.0  # its radius, m
export = pandas.DataFrame(
    {
        "Datum": [t.strftime("%d.%m.%Y") for t in clock],
        "Uhrzeit": [t.strftime("%H:%M:%S") for t in clock],
        "Kurs [°]": comma(noisy(numpy.degrees(psi), 0.05) % 360.0, 1),
        "Wendegeschw. [°/min]": comma(noisy(60.0 * numpy.degrees(r) + 0.9, 0.2), 1),
        "Ruderlage [°]": comma(noisy(-numpy.degrees(delta), 0.1), 1),
        "Fahrt durchs Wasser [kn]": comma(noisy(u / 0.514444, 0.03), 2),
        "Breite": comma(54.1 + numpy.degrees(noisy(x, 0.8) / earth), 6),
        "Länge": comma(7.9 + numpy.degrees(noisy(y, 0.8) / (earth * math.cos(math.radians(54.1)))), 6),
        "Bemerkung": "",
    }
)
export.loc[rng.random(len(export)) < 0.002, "Fahrt durchs Wasser [kn]"] = "#NV"
export.loc[900, "Bemerkung"] = "Lotse an Bord"
title = "Probefahrt MT Beispiel;;;;;;;;\r\nLogger 2, Auszug;;;;;;;;\r\n\r\n"
text = title + export.to_csv(sep=";", index=False, lineterminator="\r\n")
pathlib.Path("Probefahrt.csv").write_bytes(text.encode("cp1252"))
print("\n".join(text.splitlines()[:7]))

# %% [markdown]
# ## Import
#
# Each column and what it was taken for, and the facts of the file:

# %%
imported = swayaw.import_table(["Probefahrt.csv"])
print("\n".join(imported.notes))
swayaw.frame_of(imported.columns)

# %% [markdown]
# ## Can it be believed?
#
# `check` knows nothing of ships, only that positions, velocities, headings and rates must fit together, and that a rudder turns a ship to its own side.

# %%
check = swayaw.check(swayaw.parse_csv(imported.text, "Probefahrt"))
for error in check.told:
    print(error.words, f"({error.remedy})" if error.remedy else "")

# %% [markdown]
# So the side is settled by one line of a column map. The zero of the rate gyro is found, too, and taken off by `repaired`; nothing else is smoothed.

# %%
pathlib.Path("columns.toml").write_text('[run]\nrudder_positive = "starboard"\n')
imported = swayaw.import_table(["Probefahrt.csv"], "columns.toml")
run = swayaw.parse_csv(imported.text, "Probefahrt")
mended = swayaw.check(run)
run = swayaw.repaired(run, mended)

pieces = [piece for piece in swayaw.manoeuvres_in(run) if piece.manoeuvre.startswith(("zigzag", "turn"))]
swayaw.frame_of(pieces)[["manoeuvre", "begin", "execute", "end", "why"]]

# %% [markdown]
# ## Judged
#
# Each manoeuvre is cut out and judged, with a standard error for every number. A verdict is given where the value with two standard errors is on one side of its limit.

# %%
runs = [swayaw.piece_of(run, piece) for piece in pieces]
trials = [swayaw.trial(piece, ship) for piece in runs]
criteria = [c for trial in trials for c in trial.imo]
judged = pandas.DataFrame(
    {
        "criterion": [c.name for c in criteria],
        "first to": [c.side for c in criteria],
        "value": [c.value.value for c in criteria],
        "standard error": [c.value.standard_error for c in criteria],
        "limit": [c.limit for c in criteria],
        "unit": [c.unit for c in criteria],
        "passed": [c.passed for c in criteria],
    }
)
judged

# %%
summary = swayaw.trial_summary(trials)
for question in ("failed", "cannot_tell", "not_told"):
    print(f"{question}: {', '.join(getattr(summary, question)) or 'nothing'}")

# %%
figure, (left, right) = plt.subplots(ncols=2, figsize=(9.5, 4.2), layout="constrained")
trials[0].plot(runs[0], left)
for piece, trial in zip(runs, trials):
    if trial.turn is not None:
        for column in ("x_m", "y_m"):  # from the place of the execute
            piece[column] -= numpy.interp(piece.execute, piece.time, piece[column])
        swayaw.figures.track(piece, right, label=f"turn to {trial.turn.side}")
right.legend(fontsize="small", loc="upper left", bbox_to_anchor=(1.02, 1.0));

# %% [markdown]
# The circles wander with the current. Every place is passed again after 360 deg, which tells the current, and the lengths above are those of the track without it:

# %%
turns = [trial.turn for trial in trials if trial.turn is not None]
in_lengths = lambda told: f"{told.value / ship.length:.2f} ± {told.standard_error / ship.length:.2f}"
of_drift = lambda told, unit, digits: f"{told.value / unit:.{digits}f} ± {told.standard_error / unit:.{digits}f}"
pandas.DataFrame(
    {
        "side": t.side,
        "tactical diameter, L, as recorded": in_lengths(t.recorded.tactical_diameter),
        "without drift": in_lengths(t.corrected.tactical_diameter),
        "drift, m/s": of_drift(t.drift.speed, 1.0, 2),
        "drift to, deg": of_drift(t.drift.direction, math.radians(1), 0),
    }
    for t in turns
)

# %% [markdown]
# **What it means.** The ship passes each criterion that was sailed, by margins of many standard errors, from a file that nobody cleaned by hand. The sign of the rudder and the gyro's zero were found, not assumed; the current of 0.6 m/s
# towards 200 deg is found again.
#
# **What it cannot tell.** Standard errors hold noise, rounding, drift and the moment of the execute. They do not hold the helmsman: he gives the order up to a second after the heading has passed, and the overshoots are his as well as the
# ship's. Wind is not in a calm-water criterion; see [trials](../trial.md). The 20/20 zigzag to port was not sailed.
#
# The same at the keyboard: [from my spreadsheet to a diagnosis](../from_my_spreadsheet.md).

# %%
# Findings, as the text says them: the truth of a ship in calm water without instruments beside what was read from the file.
truth = {(c.name, c.side): c.value for c in swayaw.imo_criteria(ship).criteria}
assert check.mistake is not None and "other side" in check.mistake.words and mended.mistake is None
(gyro,) = [e for e in mended.told if e.kind == "zero"]
assert abs(gyro.value - math.radians(0.9 / 60)) < 3 * gyro.standard_error
assert [piece.manoeuvre for piece in pieces] == ["zigzag 10/10", "zigzag 10/10", "zigzag 20/20", "turn 35", "turn 35"]
assert judged["passed"].all() and not summary.failed and not summary.cannot_tell
for name, side, value, unit in judged[["criterion", "first to", "value", "unit"]].itertuples(index=False):
    assert abs(value - truth[name, side]) < (0.05 if unit == "L" else 0.5)  # half a degree is the helmsman's second
assert all(abs(t.drift.speed.value - 0.6) < 3 * t.drift.speed.standard_error for t in turns)
