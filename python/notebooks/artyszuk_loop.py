# %% [markdown]
# # The drift–yaw loop of a zigzag, and what T3 does to it
#
# **Question.** A simulator's ship has the right K and T of Nomoto, and her overshoots are wrong. Which number is missing, and which recording tells it?
#
# J. Artyszuk, *Inherent properties of ship manoeuvring linear models in view of the full-mission model adjustment*, TransNav 10 (2016), looks at a zigzag
# in the plane of drift and yaw rate. A first-order ship draws a line there; a real one draws a loop, and the loop shows the two rudder-rate constants T3b (of drift) and T3w (of yaw).
#
# Time is counted in ship lengths, s' = tU/L, and yaw rate is omega' = rL/U. The rudder angle is positive to port, so both gains are negative.

# %%
import math

import matplotlib.pyplot as plt
import numpy
import pandas

import swayaw

ship = swayaw.load_ship("tanker97_nomoto")  # the chemical tanker of the paper, table 3 as printed
indices, coefficients = ship.indices, ship.coefficients
ten = math.radians(10)
rate = ship.steering_gear.rate * ship.length / ship.service_speed  # rudder rate, rad per ship length
constants = swayaw.time_constants(coefficients)
pandas.DataFrame([{"T1": constants.T1, "T2": constants.T2, **indices._asdict()}])

# %% [markdown]
# ## A zigzag draws a loop
#
# The 10/10 zigzag is exact: every leg is a closed form and every reversal the root of one. It is sailed until each reversal repeats the one before. The dotted line is all that a first-order
# ship could do, omega' = (Kw/Kb) beta.

# %%
def loop_of(indices, axes=None):
    """The loop of the limit cycle of a ship with these indices, and its measures; drawn where there are axes."""
    other = swayaw.coefficients_from(indices)
    cycle = swayaw.limit_cycle(other, ten, ten, rate)
    if axes is not None:
        swayaw.figures.drift_yaw_loop(other, cycle.zigzag, axes)
    return swayaw.drift_yaw_loop(other, cycle.zigzag)


begin = swayaw.linear_zigzag(coefficients, ten, ten, rate, reversals=6)
run = begin.recording(coefficients, ship.scale(ship.service_speed), 1.0)

figure, (left, right) = plt.subplots(ncols=2, figsize=(9.5, 3.6), layout="constrained")
swayaw.figures.heading_and_rudder(run, left)
measures = loop_of(indices, right)
beta = numpy.array([-10.0, 10.0])
right.plot(beta, indices.Kw / indices.Kb * numpy.radians(beta), "k:", label="first order")
right.legend();

# %% [markdown]
# ## T3 as it is, doubled, halved
#
# All other indices stay. T3b belongs to drift alone: the yaw, its overshoots and its period do not know it. T3w belongs to the yaw, and the drift follows.

# %%
cases = {
    "as published": indices,
    "T3b × 2": indices._replace(T3b=2.0 * indices.T3b),
    "T3w × 1/2": indices._replace(T3w=0.5 * indices.T3w),
    "T3w × 2": indices._replace(T3w=2.0 * indices.T3w),
}
figure, axes = plt.subplots(figsize=(6.0, 4.2), layout="constrained")
rows = []
for name, case in cases.items():
    loop = loop_of(case, axes)
    zigzag = swayaw.linear_zigzag(swayaw.coefficients_from(case), ten, ten, rate, reversals=3)
    overshoots = {f"overshoot {i}, deg": math.degrees(r.overshoot) for i, r in enumerate(zigzag.reversals, 1)}
    of_loop = {"area, rad": loop.area, "beta_max, deg": math.degrees(loop.beta_max), "omega'_max": loop.omega_max}
    rows.append({"case": name, **of_loop, **overshoots})
axes.legend(cases)
table = pandas.DataFrame(rows).set_index("case")
table

# %% [markdown]
# Doubling T3b squeezes the loop along the drift axis and leaves its height; halving T3w flattens it towards the line and makes the overshoots half as large again and more: the yaw gets lazier.
# This is the number that is missing where K and T are right and the overshoots are not.
#
# ## How much, exactly
#
# `loop_sensitivity` differentiates the whole chain (inverse formulas, reversals, integrals) by dual numbers. Per cent of change for one per cent of T3:

# %%
exact = swayaw.loop_sensitivity(indices, ten, ten, rate)
told = {}
for name in ("area", "beta_max", "omega_max", "omega_at_beta_zero", "beta_at_omega_zero"):
    told[name] = [getattr(x, name) for x in (exact.value, exact.by_T3b, exact.by_T3w)]
for i in range(3):
    told[f"overshoot {i + 1}"] = [x[i] for x in (exact.overshoot, exact.overshoot_by_T3b, exact.overshoot_by_T3w)]
value, by_T3b, by_T3w = numpy.array(list(told.values())).T
by = {"by T3b": indices.T3b * by_T3b / value, "by T3w": indices.T3w * by_T3w / value}
elasticity = pandas.DataFrame(by, list(told))
axes = elasticity.plot.barh(figsize=(6.5, 3.4), ylabel="", xlabel="per cent of change for one per cent of T3")
axes.axvline(0.0, color="0.4", linewidth=0.8)
axes.invert_yaxis()
axes.figure.set_layout_engine("constrained")

# %% [markdown]
# The same by differences, a second way:

# %%
def area_with(name, factor):
    """Area of the loop where one index is that many times as large."""
    return loop_of(indices._replace(**{name: factor * getattr(indices, name)})).area


differences = {n: (area_with(n, 1.0001) - area_with(n, 0.9999)) / (0.0002 * measures.area) for n in ("T3b", "T3w")}
for name, value in differences.items():
    print(f"area by {name}: {value:+.5f} by differences, {elasticity.loc['area', f'by {name}']:+.5f} exact")

# %% [markdown]
# ## T3 speaks of the hull and the place of the rudder
#
# How much of the drift the rudder feels (c_Ry, the straightening of the flow) is feedback of the motion through the rudder. Feedback moves the time constants and leaves T3 where it is:

# %%
parts = swayaw.load_ship("tanker97").form
rows = []
for c_Ry in (0.5, 1.0, 2.0, 5.0):
    total = swayaw.coefficients_of(parts._replace(rudder=parts.rudder._replace(c_Ry=c_Ry))).total
    constants, of_it = swayaw.time_constants(total), swayaw.steering_indices(total)
    rows.append({"c_Ry": c_Ry, "T1": constants.T1, "T2": constants.T2, "T3b": of_it.T3b, "T3w": of_it.T3w})
straightening = pandas.DataFrame(rows).set_index("c_Ry")
straightening

# %% [markdown]
# So T3b and T3w, once found, need not be found anew when the rudder's area, the wake or the propeller's load change. A negative T1 is a ship that does not keep her course.
#
# ## Which recording tells T3?
#
# The zigzag above with noise, 0.1 deg in heading and 0.025 m/s in sway velocity, goes to `fit_linear` once with the sway velocity and once without.

# %%
rng = numpy.random.default_rng(1)
for column, deviation in {"psi_rad": math.radians(0.1), "r_rad_s": math.radians(0.02), "v_m_s": 0.025}.items():
    run[column] += deviation * rng.standard_normal(len(run))
fits = {
    "with sway velocity": swayaw.fit_linear([run], ship.length),
    "heading and yaw rate": swayaw.fit_linear([run], ship.length, use_drift=False),
}
rows = [{"index": name, "published": getattr(indices, name)} for name in ("T3b", "T3w", "Kw")]
for row in rows:
    for name, fit in fits.items():
        found = getattr(fit.indices, row["index"])
        row[name] = f"{found.value:.3f} ± {found.standard_error:.3f}" if math.isfinite(found.value) else "not told"
pandas.DataFrame(rows).set_index("index")

# %% [markdown]
# **What it means.** Heading and yaw rate tell T3w, and with it the overshoots. T3b is told by sway velocity alone: a trial that logs only the gyro cannot tell it, however long it is.
#
# **What this cannot tell.** The equations are linear at constant speed. Beyond 15 deg of drift, where the cubic sway force of measured hulls is half of the linear one, they mean nothing; how far does a larger zigzag go?

# %%
twenty = 2.0 * ten
larger = swayaw.limit_cycle(coefficients, twenty, twenty, rate).zigzag
largest = math.degrees(swayaw.drift_yaw_loop(coefficients, larger).beta_max)
print(f"largest drift angle, deg: 10/10 {math.degrees(measures.beta_max):.1f}, 20/20 {largest:.1f}")

# %% [markdown]
# So this study is one of 10/10 zigzags. More: [the paper recomputed](../papers/artyszuk2016.md), [linear ships](../linear.md).

# %%
# Findings, as the text says them.
as_published = table.loc["as published"]
assert measures.area > 0.04  # a loop, not a line
assert numpy.allclose(table.loc["T3b × 2"][3:], as_published[3:])  # the yaw does not know T3b
assert table.loc["T3b × 2", "area, rad"] < as_published["area, rad"]
assert table.loc["T3w × 1/2", "overshoot 1, deg"] > 1.45 * as_published["overshoot 1, deg"]  # half as large again
assert numpy.allclose(list(differences.values()), elasticity.loc["area"], rtol=1e-4)  # the derivatives are exact
assert (numpy.ptp(straightening[["T3b", "T3w"]], axis=0) < 1e-12).all()  # the rudder's inflow cancels in T3
assert straightening["T1"].iloc[0] < 0 < straightening["T1"].iloc[1]  # and decides on stability
for fit in fits.values():  # yaw tells T3w
    assert abs(fit.indices.T3w.value - indices.T3w) < 3 * fit.indices.T3w.standard_error
assert math.degrees(measures.beta_max) < 15 < largest  # 10/10 is within what linear equations are good for
assert [math.isfinite(fit.indices.T3b.value) for fit in fits.values()] == [True, False]  # sway velocity alone tells T3b
