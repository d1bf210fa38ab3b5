# %% [markdown]
# # An observer and an autopilot from a linearized ship
#
# **Question.** An autopilot is designed on a linear model, as control theory has it. Does it hold in the nonlinear ship, in wind and current, with a rudder that moves slowly and stops at 35 deg, and with a compass
# that shakes?
#
# The ship is KVLCC2, a tanker of 320 m. The linear model is made by exact derivatives of her forces. Gains come from python-control where it is installed, else from scipy. `Simulator` sails the ship.

# %%
import math

import matplotlib.pyplot as plt
import numpy
import pandas
import scipy.linalg

import swayaw

try:
    import control
except ImportError:
    control = None

ship = swayaw.published_ship("kvlcc2")


def model_at(speed=None):
    """Small motions about the straight course at that speed [m/s], in seconds: states v, r, psi."""
    linear = swayaw.linearize(ship, swayaw.straight_course(ship, speed))
    return swayaw.dimensional(linear.sway_yaw, linear.scale).state_space(heading=True)


model = model_at()
derivatives = pandas.DataFrame(model.A, [f"d({x})/dt by" for x in model.states], model.states)
derivatives.assign(delta=model.B).rename_axis("")

# %%
slow = max(pole for pole in model.poles.real if pole != 0.0)
print("poles, 1/s:", numpy.array2string(numpy.sort(model.poles), precision=5))
print(f"slowest time constant {-1 / slow / 60:.0f} min")

# %% [markdown]
# One pole is that of the heading, one nearly as slow: left alone, this ship hardly keeps her course. That is what an autopilot is for.
#
# ## The design
#
# The autopilot acts once a second. Only the compass is read. A fourth state stands for what wind does: a rudder angle that nobody ordered, which the observer has to find.
#
#     x(k+1) = A x(k) + B (delta + d),   d(k+1) = d(k),   y = psi + noise
#
# The regulator weighs 1 deg of heading like 1 deg of rudder; the observer trusts the compass to 0.2 deg. Both are solutions of a Riccati equation.

# %%
dt = 1.0
sampled = model.to_control().sample(dt) if control else model.to_scipy().to_discrete(dt)
A, B = numpy.asarray(sampled.A), numpy.asarray(sampled.B)


def regulator(A, B, Q, R):
    """The gain that makes Σ xᵀ Q x + uᵀ R u least."""
    if control:
        return numpy.asarray(control.dlqr(A, B, Q, R)[0])
    P = scipy.linalg.solve_discrete_are(A, B, Q, R)
    return numpy.linalg.solve(R + B.T @ P @ B, B.T @ P @ A)


deg = math.radians(1)
K = regulator(A, B, numpy.diag([0.0, 0.0, 1.0]), numpy.eye(1))

A_d = numpy.block([[A, B], [numpy.zeros((1, 3)), numpy.eye(1)]])  # with the rudder angle d that nobody ordered
B_d, C_d = numpy.vstack([B, [[0.0]]]), numpy.array([[0.0, 0.0, 1.0, 0.0]])
walk = numpy.diag([0.005, 0.002 * deg, 0.0, 0.02 * deg]) ** 2  # of v [m/s], r, psi and d [rad] in a step
L = regulator(A_d.T, C_d.T, walk, numpy.array([[(0.2 * deg) ** 2]])).T

print("rudder by v, r, psi:", numpy.array2string(-K[0], precision=3))
print("slowest poles of regulator and observer: time constants of", end=" ")
print(", ".join(f"{-dt / math.log(max(abs(numpy.linalg.eigvals(m)))):.0f} s" for m in (A - B @ K, A_d - L @ C_d)))

# %% [markdown]
# ## Sailed
#
# The loop below is all of the autopilot: what the observer believes, the rudder order, one second in the nonlinear ship. Without the fourth state it is an ordinary heading controller.

# %%
def sail(course, seconds, *, wind=None, current=None, noise=0.0, finds_wind=True, speed=None, seed=1):
    """Changes course [rad] after a minute; a table of heading, rudder, and the rudder angle that the wind is worth."""
    at_sea, rng = swayaw.Simulator(ship, speed=speed), numpy.random.default_rng(seed)
    if wind:
        at_sea.set_wind(*wind)
    if current:
        at_sea.set_current(*current)
    believed, rows = numpy.zeros((4, 1)), []
    for k in range(int(seconds / dt)):
        wanted = course if k * dt >= 60.0 else 0.0
        off = believed[:3] - numpy.array([[0.0], [0.0], [wanted]])
        order = float((-K @ off).item()) - (believed[3, 0] if finds_wind else 0.0)
        order = min(max(order, -ship.steering_gear.max_angle), ship.steering_gear.max_angle)
        compass = at_sea.state.psi + noise * rng.standard_normal()
        believed = A_d @ believed + B_d * order + L * (compass - believed[2, 0])
        at_sea.order_rudder(order)
        at_sea.step(dt)
        state = at_sea.state
        rows.append((at_sea.time, wanted, state.psi, at_sea.rudder, believed[3, 0], state.motion.v, believed[0, 0]))
    return pandas.DataFrame(rows, columns=["time", "wanted", "psi", "delta", "d", "v", "v_believed"])


def linear_sail(course, seconds):
    """The same of the linear ship, whose rudder is where it was ordered."""
    x, rows = numpy.zeros((3, 1)), []
    for k in range(int(seconds / dt)):
        delta = -K @ (x - numpy.array([[0.0], [0.0], [course if k * dt >= 60.0 else 0.0]]))
        x = A @ x + B @ delta
        rows.append(((k + 1) * dt, x[2, 0], delta.item()))
    return pandas.DataFrame(rows, columns=["time", "psi", "delta"])


figure, all_axes = plt.subplots(ncols=2, nrows=2, sharex=True, figsize=(9.5, 5.0), layout="constrained")
furthest = {}
for course, (top, bottom) in zip((10, 60), all_axes.T):
    calm, ideal = sail(course * deg, 900), linear_sail(course * deg, 900)
    furthest[course] = numpy.degrees(abs(calm["psi"] - ideal["psi"])).max()
    for name, run in (("nonlinear ship", calm), ("linear model", ideal)):
        top.plot(run["time"], numpy.degrees(run["psi"]), label=name)
        bottom.plot(run["time"], -numpy.degrees(run["delta"]), label=name)
    top.set(title=f"course changed by {course} deg", ylabel="heading, deg")
    bottom.set(xlabel="time, s", ylabel="rudder to starboard, deg")
    bottom.legend()
print(", ".join(f"{course} deg: heading up to {off:.1f} deg apart" for course, off in furthest.items()))

# %% [markdown]
# A change of 10 deg goes as the linear model foretells. At 60 deg the rudder stands at its stop, the ship loses speed in the turn, and the two part; the loop still ends on the new course.
#
# ## In wind and current
#
# A gale of 20 m/s from 110 deg, abeam on the new course, a current of 0.5 m/s, a compass that shakes by 0.2 deg.

# %%
weather = dict(wind=(20.0, math.radians(110)), current=(0.5, math.radians(150)), noise=0.2 * deg)
with_wind = sail(20 * deg, 2400, **weather)
without = sail(20 * deg, 2400, **weather, finds_wind=False)

figure, (top, bottom) = plt.subplots(nrows=2, sharex=True, figsize=(8.0, 5.0), layout="constrained")
for name, run in (("observer finds the wind", with_wind), ("observer does not use it", without)):
    top.plot(run["time"], numpy.degrees(run["psi"] - run["wanted"]), linewidth=1, label=name)
top.set(ylabel="heading off the course, deg", ylim=(-2.5, 2.5))
top.axhline(0.0, color="0.6", linewidth=0.8)
top.legend()
bottom.plot(with_wind["time"], -numpy.degrees(with_wind["delta"]), linewidth=0.8, label="rudder to starboard")
bottom.plot(with_wind["time"], numpy.degrees(with_wind["d"]), label="found by the observer")
bottom.set(xlabel="time, s", ylabel="deg")
steady = swayaw.steady_run_in_wind(ship, *weather["wind"], direction=20 * deg, kept="heading")
bottom.axhline(-numpy.degrees(steady.delta), color="k", linestyle=":", label="helm of the steady run")
bottom.legend()

settled = slice(1200, None)
off = lambda run: numpy.degrees((run["psi"] - run["wanted"])[settled].mean())
standing = {"with the wind's state": off(with_wind), "without": off(without)}
found = numpy.degrees(-with_wind["d"][settled].mean())
print("standing error of the heading, deg:", ", ".join(f"{value:+.3f} {how}" for how, value in standing.items()))
print(f"helm, to port: {found:+.3f} deg found, {numpy.degrees(steady.delta):+.3f} deg by the equilibrium of the forces")

# %% [markdown]
# The dotted line is a second way to the same number: the helm at which all forces of the nonlinear ship in that wind are in balance, by Newton's method. The observer, which knows a linear ship and a compass, finds it.
#
# ## At other speeds
#
# The gains belong to the service speed. What becomes of the loop, regulator and observer together, when the ship goes slower and nobody tells the autopilot?

# %%
def slowest_of_loop(speed):
    """Largest modulus of the poles of ship, regulator and observer together; stable below 1."""
    other = model_at(speed).to_scipy().to_discrete(dt)
    a, b = numpy.asarray(other.A), numpy.asarray(other.B)
    order = -numpy.hstack([K, [[1.0]]])  # of what the observer believes
    loop = numpy.block([[a, b @ order], [L @ C_d[:, :3], A_d + B_d @ order - L @ C_d]])
    return max(abs(numpy.linalg.eigvals(loop)))


speeds = numpy.linspace(0.15, 1.2, 22) * ship.service_speed
moduli = numpy.array([slowest_of_loop(speed) for speed in speeds])
figure, axes = plt.subplots(figsize=(6.0, 3.0), layout="constrained")
axes.plot(speeds, 60.0 * numpy.log(moduli) / dt, ".-")
axes.set(xlabel="speed, m/s", ylabel="growth of the slowest mode, 1/min")
axes.axvline(ship.service_speed, color="0.6", linewidth=0.8, label="service speed")
axes.axhline(0.0, color="k", linewidth=0.8)
axes.legend()
lowest = speeds[moduli < 1].min()
print(f"stable from {lowest:.1f} m/s up, {lowest / ship.service_speed:.0%} of the service speed")

# %% [markdown]
# Is that so in the nonlinear ship? The same change of course by 10 deg at half the service speed, and well below the limit:

# %%
figure, axes = plt.subplots(figsize=(8.0, 3.0), layout="constrained")
slow_runs = {speed: sail(10 * deg, 7200, speed=speed) for speed in (0.5 * ship.service_speed, 0.6 * lowest)}
for speed, run in slow_runs.items():
    axes.plot(run["time"] / 60, numpy.degrees(run["psi"]), label=f"{speed:.1f} m/s")
axes.set(xlabel="time, min", ylabel="heading, deg")
axes.legend();

# %% [markdown]
# **What it means.** The linear design holds in the nonlinear ship as long as the rudder is not at its stop and the speed is not too far from that of the design; the linear model tells beforehand how far that is. The wind's moment is found
# with the compass alone, and the standing error goes.
#
# **What it cannot tell.** There are no waves here: first-order yawing would need a notch or a wave model in the observer, or the rudder works for nothing. The wind is steady. The sway velocity that the observer believes is not the true one in wind, for the
# fourth state stands for a moment and not for the side force; nothing here depends on it.
#
# More: [linear ships](../linear.md), [load of the wind](../wind.md), [simulation](../simulation.md).

# %%
# Findings, as the text says them.
assert slow > -1 / 3600  # a time constant above an hour: she hardly keeps her course
assert furthest[10] < 2.0 < furthest[60]  # deg
assert abs(numpy.degrees(sail(60 * deg, 1800)["psi"].iloc[-1]) - 60) < 0.5
assert abs(standing["with the wind's state"]) < 0.05 and abs(standing["without"]) > 0.2
assert abs(found - numpy.degrees(steady.delta)) < 0.05  # the observer's helm is that of the equilibrium
assert (moduli[speeds >= lowest] < 1).all() and 0.15 < lowest / ship.service_speed < 0.5
end_of = lambda run: numpy.degrees((run["psi"] - run["wanted"])[-1200:]).abs().max()  # in the last 20 minutes
assert end_of(slow_runs[0.5 * ship.service_speed]) < 0.5 < end_of(slow_runs[0.6 * lowest])
