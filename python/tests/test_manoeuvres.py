"""Manoeuvres: the numbers of the program, to the last bit."""

import json
import math
import pickle

import numpy
import pytest

import swayaw


def test_a_zigzag_is_that_of_the_program(program, ship, tmp_path):
    file = tmp_path / "zigzag.csv"
    told = json.loads(program("simulate", "kvlcc2", "--zigzag", "10/10", "--out", file, "--json"))
    result = swayaw.zigzag(ship, math.radians(10), math.radians(10))
    run = swayaw.read_csv(file)
    assert numpy.array_equal(run.time, result.run.time)
    assert run.columns == result.run.columns
    for column in run.columns:
        assert numpy.array_equal(run[column], result.run[column], equal_nan=True), column
    assert [math.degrees(r.overshoot) for r in result.reversals] == pytest.approx(told["overshoot_deg"], rel=1e-15)
    assert result.period == told["period_s"]


def test_a_turning_circle_is_that_of_the_program(program, ship):
    told = json.loads(program("simulate", "kvlcc2", "--turn", "35", "--first", "port", "--json"))
    result = swayaw.turning_circle(ship, math.radians(35), "port")
    for key in ("advance", "transfer", "tactical_diameter", "final_diameter"):
        assert getattr(result, key) == told[f"{key}_m"]


def test_criteria_are_those_of_the_program(program, ship):
    told = json.loads(program("simulate", "kvlcc2", "--imo", "--json"))
    criteria = swayaw.imo_criteria(ship).criteria
    shown = [(c["value"], c["limit"], c["pass"]) for c in told["criteria"]]
    assert [(c.value, c.limit, c.passed) for c in criteria] == shown


def test_results_travel_without_a_change(ship, zigzag):
    results = [
        zigzag,
        swayaw.turning_circle(ship, math.radians(35)),
        swayaw.imo_criteria(ship),
        swayaw.williamson_turn(ship),
        swayaw.spiral(ship, math.radians(10), math.radians(5)),
        swayaw.pull_out(ship, math.radians(20)),
        swayaw.reverse_spiral(ship),
    ]
    for result in results:
        assert pickle.loads(pickle.dumps(result)) == result
        assert repr(result).startswith(type(result).__name__)


def test_port_and_starboard_turn_to_their_sides(ship):
    assert swayaw.turning_circle(ship, math.radians(35), "port").steady.r < 0.0
    assert swayaw.turning_circle(ship, math.radians(35), "starboard").steady.r > 0.0
    with pytest.raises(ValueError, match='"left" is none of port, starboard'):
        swayaw.turning_circle(ship, math.radians(35), "left")


def test_bad_questions_are_refused_in_words(ship):
    with pytest.raises(ValueError, match="rudder angle 572.958 deg is beyond the ship's largest, 35 deg"):
        swayaw.zigzag(ship, 10, 10)
    with pytest.raises(ValueError, match="must be positive, got -0.1"):
        swayaw.zigzag(ship, -0.1, 0.1)


def test_without_samples_the_indices_are_the_same(ship, zigzag):
    bare = swayaw.zigzag(ship, math.radians(10), math.radians(10), sampled=False)
    assert len(bare.run.time) == 0
    assert [r.overshoot for r in bare.reversals] == pytest.approx([r.overshoot for r in zigzag.reversals], abs=1e-7)


def test_an_unstable_ship_has_a_loop():
    ship = swayaw.published_ship("kvlcc2")
    curve = swayaw.steady_turn_curve(ship, math.radians(20))
    assert any(not turn.stable for turn in curve) == (swayaw.instability_loop(curve) is not None)


def test_exact_derivatives_of_indices_are_those_of_differences(model):
    names = ["N_v", "Y_r", "rate_deg_s"]
    slopes = swayaw.zigzag_slopes(model, math.radians(20), math.radians(20), names)
    for i, name in enumerate(names):
        value, step = model.parameters[name].value, 1e-5 * abs(model.parameters[name].value)

        def overshoots(changed):
            ship = model.with_values({name: changed})
            result = swayaw.zigzag(ship, math.radians(20), math.radians(20), sampled=False, tolerance=1e-12)
            return numpy.array([r.overshoot for r in result.reversals])

        differences = (overshoots(value + step) - overshoots(value - step)) / (2.0 * step)
        exact = numpy.array([slopes[f"overshoot[{k}]"][i] for k in range(4)])
        assert exact == pytest.approx(differences, rel=2e-4, abs=1e-9)


def test_fields_say_what_they_are():
    assert swayaw.Zigzag.__annotations__["run"] == "swayaw.Recording"
    assert swayaw.Zigzag.period.__doc__ == "Of the last full cycle, reversal to the next but one [s]."
