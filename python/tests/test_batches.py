"""Many ships at once: what each of them does alone, and other threads meanwhile."""

import math
import pickle
import threading

import numpy
import pytest

import swayaw

TEN = math.radians(10)


def test_each_ship_of_a_batch_sails_as_she_does_alone(ship):
    values = numpy.linspace(0.8, 1.2, 9) * ship.parameters["N_r"].value
    batch = swayaw.zigzag_batch(ship, {"N_r": values}, TEN, TEN)
    assert batch.overshoot.shape == (4, 9) and batch.end == ["complete"] * 9 and list(batch.count) == [4] * 9
    for k in (0, 8):
        alone = swayaw.zigzag(ship.with_values({"N_r": values[k]}), TEN, TEN, sampled=False)
        assert batch.overshoot[:, k] == pytest.approx([r.overshoot for r in alone.reversals], rel=1e-5)
        assert batch.time[:, k] == pytest.approx([r.time for r in alone.reversals], rel=1e-5)
    same = swayaw.zigzag_batch([ship.with_values({"N_r": x}) for x in values], TEN, TEN, threads=1)
    assert same == batch and pickle.loads(pickle.dumps(batch)) == batch


def test_what_a_batch_cannot_sail_is_refused_in_words(ship):
    with pytest.raises(swayaw.Refusal, match="steady_current"):
        swayaw.zigzag_batch([ship.with_effect("steady_current", current_speed_m_s=0.5, current_to_rad=0.0)], TEN, TEN)
    with pytest.raises(swayaw.Refusal, match="mmg"):
        swayaw.zigzag_batch([swayaw.published_ship("kvlcc2_pi")], TEN, TEN)
    with pytest.raises(ValueError, match="N_r has 2"):
        swayaw.zigzag_batch(ship, {"N_r": [-0.04, -0.05], "N_v": [-0.1]}, TEN, TEN)
    with pytest.raises(ValueError, match="R_0 in .hull. cannot be -1"):
        swayaw.zigzag_batch(ship, {"R_0": [-1.0]}, TEN, TEN)
    with pytest.raises(swayaw.Refusal, match="N_w"):
        swayaw.zigzag_batch(ship, {"N_w": [0.1]}, TEN, TEN)


def test_other_threads_go_on(ship):
    values = numpy.full(3000, ship.parameters["N_v"].value)
    elsewhere, stop = [], threading.Event()

    def count():
        while not stop.wait(0.001):
            elsewhere.append(1)

    other = threading.Thread(target=count)
    other.start()
    try:
        before = len(elsewhere)
        swayaw.zigzag_batch(ship, {"N_v": values}, TEN, TEN)
        during = len(elsewhere) - before
    finally:
        stop.set()
        other.join()
    assert during > 3


def test_linear_ships_sail_as_each_alone():
    ship = swayaw.load_ship("tanker97")
    c2 = numpy.linspace(0.7, 1.3, 11) * ship.coefficients.c2
    batch = swayaw.linear_zigzag_batch(ship.coefficients, {"c2": c2}, TEN, TEN, 0.5)
    for k in (0, 10):
        alone = swayaw.linear_zigzag(ship.coefficients._replace(c2=c2[k]), TEN, TEN, 0.5)
        switches = [r.execute for r in alone.reversals]
        assert batch.execute[: len(switches), k] == pytest.approx(switches, abs=1e-9)
    assert batch.overshoot.shape == (6, 11) and pickle.loads(pickle.dumps(batch)) == batch
    with pytest.raises(ValueError, match="d2 is none of"):
        swayaw.linear_zigzag_batch(ship.coefficients, {"d2": c2}, TEN, TEN, 0.5)


def test_a_map_holds_the_loops_of_its_ships():
    ship = swayaw.load_ship("tanker97")
    indices = swayaw.steering_indices(ship.coefficients)
    T3b, T3w = indices.T3b * numpy.array([0.9, 1.0, 1.1]), indices.T3w * numpy.array([1.0, 1.2])
    t3 = swayaw.t3_map(indices, TEN, TEN, 0.5, T3b, T3w)
    assert t3.area.shape == (2, 3)
    other = swayaw.coefficients_from(indices._replace(T3b=T3b[2], T3w=T3w[1]))
    loop = swayaw.drift_yaw_loop(other, swayaw.limit_cycle(other, TEN, TEN, 0.5).zigzag)
    assert t3.area[1, 2] == pytest.approx(loop.area, rel=1e-6)
    assert t3.beta_max[1, 2] == pytest.approx(loop.beta_max, rel=1e-6)
    assert pickle.loads(pickle.dumps(t3)) == t3
