"""Coefficients from measured indices: the same ship as the program makes, and one that was hidden."""

import json
import math
import pickle

import numpy
import pytest

import swayaw


@pytest.fixture(scope="module")
def nawigator():
    return swayaw.published_ship("nawigator_ym")


@pytest.fixture(scope="module")
def measured(source, nawigator):
    return swayaw.read_indices(source / "examples/indices/nawigator.toml", nawigator.length)


@pytest.fixture(scope="module")
def tuning(nawigator, measured):
    return swayaw.tune(nawigator, measured, prior=1.0, most_change=1.0)


def test_measured_indices_are_those_of_the_file(measured, nawigator):
    assert [trial.name for trial in measured.trials][::3] == ["turn 35 to starboard", "zigzag 10/20 first starboard"]
    advance = {i.name: i for i in measured.trials[0].indices}["advance_L"]
    assert advance.value == 2.2 * nawigator.length
    assert advance.deviation == pytest.approx(0.05 * advance.value)
    assert measured.trials[0].manoeuvre == swayaw.TurnOrder(math.radians(35), "starboard")
    assert pickle.loads(pickle.dumps(measured)) == measured


def test_dictionaries_say_what_a_file_says(nawigator):
    told = swayaw.measured_indices(
        nawigator.length, speed=5.91, tolerance=0.1,
        turns=[{"rudder_deg": 35, "side": "port", "advance_L": 2.2, "final_yaw_rate_rad_s": {"value": 0.048, "sd": 0.001}}],
        zigzags=[{"rudder_deg": 10, "heading_deg": 20, "overshoot_deg": numpy.array([15.5, 19.0])}],
    )
    turn, zigzag = told.trials
    assert told.speed == 5.91 and turn.name == "turn 35 to port" and zigzag.name == "zigzag 10/20 first starboard"
    assert {i.name: i.deviation for i in turn.indices}["final_yaw_rate_rad_s"] == 0.001
    assert [math.degrees(i.value) for i in zigzag.indices] == pytest.approx([15.5, 19.0])
    with pytest.raises(swayaw.FileError, match=r"measured indices:3:\d+: advans_L in .* is not known"):
        swayaw.measured_indices(56.0, turns=[{"rudder_deg": 35, "advans_L": 2.2}])


def test_tuning_is_that_of_the_program(tuning, program, source, tmp_path):
    file = source / "examples/indices/nawigator.toml"
    out = tmp_path / "tuned.toml"
    told = json.loads(
        program("tune", "nawigator_ym", "--indices", file, "--prior", 1, "--bound", 1, "--out", out, "--json")
    )
    assert tuning.status == told["status"] == "converged"
    assert [(p.name, p.before, p.after, p.told) for p in tuning.parameters] == [
        (n["name"], n["before"], n["after"], n["told"]) for n in told["numbers"]
    ]
    assert (tuning.before.turns, tuning.after.zigzags) == (told["error"]["turns"]["before"], told["error"]["zigzags"]["after"])
    assert tuning.ship == swayaw.read_ship(out)


def test_a_tuning_travels_and_shows_itself(tuning):
    assert pickle.loads(pickle.dumps(tuning)) == tuning
    assert pickle.loads(pickle.dumps(tuning.parameters[0].number)) == tuning.parameters[0].number
    assert "told by the indices" in tuning._repr_html_()


def test_a_hidden_coefficient_is_found(model):
    hidden = model.with_values({"N_v": 1.2 * model.parameters["N_v"].value})
    angle = math.radians(10)
    sailed = swayaw.zigzag(hidden, angle, angle, sampled=False)
    circle = swayaw.turning_circle(hidden, math.radians(35))
    measured = swayaw.measured_indices(
        model.length, tolerance=0.01,
        turns=[{"rudder_deg": 35, "advance_m": circle.advance, "tactical_diameter_m": circle.tactical_diameter}],
        zigzags=[{"rudder_deg": 10, "heading_deg": 10,
                  "overshoot_deg": [math.degrees(r.overshoot) for r in sailed.reversals[:2]]}],
    )
    heard = []
    tuning = swayaw.tune(model, measured, ["N_v"], prior=10.0, progress=lambda count, error: heard.append((count, error)))
    (found,) = tuning.parameters
    assert found.after == pytest.approx(hidden.parameters["N_v"].value, rel=1e-4) and found.determined
    assert heard[-1][0].turns > 0 and heard[-1][1].turns < 1e-6


def test_a_listener_ends_a_tuning_with_the_best_ship(nawigator, measured):
    tuning = swayaw.tune(nawigator, measured, progress=lambda *_: False)
    assert tuning.status == "interrupted"


def test_sensitivities_are_those_of_sailed_manoeuvres(model):
    measured = swayaw.measured_indices(model.length, turns=[{"rudder_deg": 35, "final_diameter_L": 3.0}])
    names = [p.name for p in swayaw.tuned_parameters(model, ["N_v", "N_r"])]
    assert names == ["N_v", "N_r"]
    told = swayaw.index_sensitivity(model, measured, names)
    more = model.with_values({"N_r": 1.001 * model.parameters["N_r"].value})
    diameters = [swayaw.turning_circle(s, math.radians(35)).final_diameter for s in (model, more)]
    assert told.indices[0] == pytest.approx(diameters[0], rel=1e-9)
    assert told.exact[0, 1] == pytest.approx(1000.0 * math.log(diameters[1] / diameters[0]), rel=2e-3)
    best, worst = swayaw.determined_combinations(told.exact, [0.05])
    assert best.determined and not worst.determined
    assert best.singular_value == pytest.approx(numpy.linalg.norm(told.exact) / 0.05)


def test_what_cannot_be_tuned_is_refused_in_words(model, measured):
    with pytest.raises(swayaw.Refusal, match="N_w"):
        swayaw.tune(model, measured, ["N_w"])
    with pytest.raises(ValueError, match="most_change|bound|positive"):
        swayaw.tune(model, measured, most_change=-1.0)
