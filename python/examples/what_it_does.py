"""What docs/peers.md says the module can do and no command of the program shows, one line for each.

    python3 python/examples/what_it_does.py
"""

import math
import pathlib
import tempfile

import numpy
import scipy.io

import swayaw

ship, model = swayaw.published_ship("kvlcc2"), swayaw.published_ship("kvlcc2_l7")
hard_over, twenty = math.radians(35), math.radians(20)


def circle(words: str, other: swayaw.Ship) -> None:
    turn = swayaw.turning_circle(other, hard_over)
    advance, diameter = turn.advance / other.length, turn.tactical_diameter / other.length
    print(f"{words}: advance {advance:.2f} L, tactical diameter {diameter:.2f} L")


# surroundings and roll are effects of the ship; waves act by their mean force only
circle("35 deg turn", ship)
circle("in a current of 1 m/s", ship.with_effect("steady_current", current_speed_m_s=1.0, current_to_rad=0.0))
circle("in a wind of 15 m/s", ship.with_effect("steady_wind", wind_speed_m_s=15.0, wind_from_rad=math.radians(60)))
circle("in waves of 300 kN", ship.with_effect("wave_drift", wave_from_rad=math.radians(60), force_N=3e5))
circle("on 1.5 times her draught", ship.with_effect("shallow_water", depth_over_draught=1.5))
circle("with roll, GM 2 m", ship.with_effect("roll_coupling", GM_m=2.0))

run = swayaw.steady_run_in_wind(ship, 15.0, math.radians(60))
print(f"course kept in that wind: helm {math.degrees(run.delta):.2f} deg, leeway {math.degrees(run.leeway):.2f} deg")

# exact derivatives of the right-hand side, for other tools; the loop of a helmsman who orders half the heading error
linear = swayaw.linearize(ship, swayaw.straight_course(ship))
print("poles with the heading [1/s]:", numpy.array2string(linear.state_space(heading=True).poles, precision=4))
loop = swayaw.crossover(swayaw.transfer_functions(linear.sway_yaw), 0.5)
margin = math.degrees(loop.phase_margin)
print(f"helmsman of gain 0.5: crossover {loop.frequency:.2f} rad per ship length, phase margin {margin:.0f} deg")

# states from noisy position and heading: extended Kalman filter and smoother, noise not told
clean, noisy = (swayaw.zigzag(model, twenty, twenty, step=0.25).run for _ in range(2))
rng = numpy.random.default_rng(1)
for column, deviation in {"x_m": 0.02, "y_m": 0.02, "psi_rad": 1e-3}.items():
    noisy[column] += deviation * rng.standard_normal(len(noisy))
states = swayaw.estimate_states(model, noisy, channels=["x", "y", "psi"])
error = math.degrees(numpy.sqrt(numpy.mean((states.states[:, 5] - clean["r_rad_s"]) ** 2)))
print(f"yaw rate from position and heading alone: error {error:.4f} deg/s, heading noise {states.noise['psi']:.1e} rad")

# a log of NMEA 0183, and a file of MATLAB
beats = [(0.5 * i, 45.0 + 0.1 * i) for i in range(20)]
with tempfile.TemporaryDirectory() as folder:
    log, matlab = pathlib.Path(folder) / "bridge.log", pathlib.Path(folder) / "run.mat"
    log.write_text("".join(f"{t} $HEHDT,{psi:.2f},T\n{t} $AGRSA,10.0,A,,V\n" for t, psi in beats), encoding="ascii")
    time, heading = numpy.transpose(beats)
    scipy.io.savemat(matlab, {"t_s": time, "heading_deg": heading, "rudder_deg": numpy.full(20, 10.0)})
    for kind, found in (("NMEA", swayaw.import_nmea([log])), ("MATLAB", swayaw.import_mat(matlab))):
        print(f"{kind}:", ", ".join(f"{c.source} is {c.taken_for}" for c in found.columns))

# the loop of a simulator, in steps of its own
simulator = swayaw.Simulator(ship)
simulator.order_rudder(-twenty)
for _ in range(50 * 60):
    simulator.step(0.02)
state = simulator.state
print(f"after a minute at 20 deg: heading {math.degrees(state.psi):.1f} deg, {state.motion.u:.2f} m/s")
