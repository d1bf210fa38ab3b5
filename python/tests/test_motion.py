"""Forces, linearization, replay, real time, threads."""

import concurrent.futures
import math
import threading
import time

import numpy
import pytest

import swayaw


def test_forces_by_part_add_up(ship):
    state = swayaw.ShipState(0.0, 0.0, 0.0, swayaw.PlanarMotion(7.0, -0.5, 0.004))
    forces = swayaw.force_breakdown(ship, state, swayaw.self_propulsion(ship)._replace(delta=0.2))
    for axis in "XYN":
        total = sum(getattr(part, axis) for part in forces.parts.values())
        assert total == pytest.approx(getattr(forces.total, axis), rel=1e-9)
    with pytest.raises(swayaw.Refusal, match="ahead"):
        swayaw.force_breakdown(ship, state._replace(motion=swayaw.PlanarMotion(-1.0, 0.0, 0.0)), swayaw.Controls())


@pytest.mark.parametrize("name", ["kvlcc2", "kvlcc2_pi", "wpcc_pu", "mariner"])
def test_linearization_is_that_of_differences(name):
    ship = swayaw.published_ship(name)
    point = swayaw.straight_course(ship)
    turning = swayaw.steady_motion(ship, point.controls._replace(delta=math.radians(-10)), point.motion)
    point = swayaw.OperatingPoint(turning.motion, point.controls._replace(delta=math.radians(-10)))
    linear = swayaw.linearize(ship, point)

    def acceleration(x):
        motion = swayaw.PlanarMotion(*x[:3])
        state = swayaw.ShipState(0.0, 0.0, 0.0, motion)
        a = swayaw.force_breakdown(ship, state, point.controls._replace(delta=x[3])).acceleration
        return numpy.array([a.u, a.v, a.r])

    at = numpy.array([point.motion.u, point.motion.v, point.motion.r, point.controls.delta])
    for k, size in enumerate([at[0], at[0], at[0] / ship.length, 1.0]):
        step = numpy.zeros(4)
        step[k] = 1e-5 * size
        differences = (acceleration(at + step) - acceleration(at - step)) / (2.0 * step[k])
        exact = numpy.hstack([linear.A, linear.B])[:, k]
        assert exact == pytest.approx(differences, rel=1e-6, abs=1e-6 * numpy.abs(exact).max())


def test_parts_of_a_linearization_add_up(ship):
    linear = swayaw.linearize(ship, swayaw.straight_course(ship))
    assert sum(A for A, B in linear.parts.values()) == pytest.approx(linear.A, rel=1e-9, abs=1e-15)
    assert sum(B for A, B in linear.parts.values()) == pytest.approx(linear.B, rel=1e-9, abs=1e-15)
    poles = sorted(numpy.linalg.eigvals(linear.A).real)
    assert poles == pytest.approx(sorted(p.real for p in linear.poles), rel=1e-9)
    assert linear.state_space(heading=True).states == ("u", "v", "r", "psi")


def test_a_replay_of_a_simulation_is_that_simulation(ship, zigzag):
    again = swayaw.replay(ship, zigzag.run)
    assert again["psi_rad"] == pytest.approx(zigzag.run["psi_rad"], abs=2e-3)


def test_a_run_without_rudder_is_refused_in_words(ship):
    run = swayaw.Recording([0.0, 1.0, 2.0], {"psi_rad": [0.0, 0.1, 0.2], "u_m_s": [7.0, 7.0, 7.0]})
    with pytest.raises(swayaw.Refusal, match="rudder"):
        swayaw.replay(ship, run)


def test_forces_stand_beside_the_samples(ship, zigzag):
    run = swayaw.with_forces(zigzag.run, ship)
    assert "Y_rudder_N" in run.to_dataframe().columns


def test_a_simulator_turns_as_the_manoeuvre_does(ship):
    circle = swayaw.turning_circle(ship, math.radians(35), duration=200.0, step=1.0)
    sim = swayaw.Simulator(ship)
    sim.order_rudder(math.radians(-35))
    for _ in range(200 * 50):
        sim.step(0.02)
    assert sim.time == pytest.approx(200.0)
    assert sim.state.x == pytest.approx(circle.run["x_m"][200], abs=1e-5 * ship.length)
    assert sim.state.psi == pytest.approx(circle.run["psi_rad"][200], abs=1e-5)
    assert sim.valid and sim.rudder == math.radians(-35)
    assert sim.instruments["psi_rad"] == sim.state.psi


def test_a_simulator_drifts_with_the_current(ship):
    sim = swayaw.Simulator(ship)
    sim.set_current(1.0, math.pi / 2)
    for _ in range(1000):
        sim.step(0.1)
    assert sim.state.y == pytest.approx(100.0, abs=0.1)
    with pytest.raises(ValueError, match="finite"):
        sim.order_rudder(math.nan)
    with pytest.raises(swayaw.Refusal, match="wind"):
        swayaw.Simulator(swayaw.published_ship("mariner")).set_wind(10.0, 0.0)


def test_a_force_of_the_user_pushes(ship):
    sim = swayaw.Simulator(ship)
    sim.set_added_force(swayaw.PlanarForce(0.0, 1e6, 0.0))
    sim.step(1.0)
    assert sim.state.motion.v > 0.0 and sim.forces["given"].Y == 1e6


def test_wind_bends_a_course():
    ship = swayaw.published_ship("esso_osaka_3m")
    calm = swayaw.steady_run_in_wind(ship, 0.0, 0.0)
    windy = swayaw.steady_run_in_wind(ship, 1.0, math.pi / 2)
    assert calm.delta == pytest.approx(0.0, abs=0.02) and windy.leeway < 0.0


def test_the_work_is_done_without_the_lock(ship):
    """While one thread works, another goes on counting."""
    counted, done = 0, threading.Event()

    def work():
        swayaw.spiral(ship, math.radians(25), math.radians(1))
        done.set()

    thread = threading.Thread(target=work)
    thread.start()
    while not done.is_set():
        time.sleep(0)
        counted += 1
    thread.join()
    assert counted > 100


def test_threads_give_the_same_answers(ship):
    angles = [math.radians(d) for d in range(5, 36, 5)]
    alone = [swayaw.turning_circle(ship, a) for a in angles]
    with concurrent.futures.ThreadPoolExecutor(4) as pool:
        together = list(pool.map(lambda a: swayaw.turning_circle(ship, a), angles))
    assert together == alone
