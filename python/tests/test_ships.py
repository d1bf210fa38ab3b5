"""Ships: files, parameters, effects."""

import copy
import math
import pickle

import pytest

import swayaw

NONLINEAR = [n for n in swayaw.published_ships() if isinstance(swayaw.load_ship(n), swayaw.Ship)]
LINEAR = [n for n in swayaw.published_ships() if n not in NONLINEAR]


@pytest.mark.parametrize("name", NONLINEAR)
def test_a_ship_travels_without_a_change(name, tmp_path):
    ship = swayaw.published_ship(name)
    ship.save(tmp_path / "ship.toml", remark="kept")
    for other in (
        swayaw.read_ship(tmp_path / "ship.toml"),
        swayaw.parse_ship(ship.text()),
        pickle.loads(pickle.dumps(ship)),
        copy.deepcopy(ship),
    ):
        assert other == ship and hash(other) == hash(ship)
        for key, parameter in ship.parameters.items():
            assert other.parameters[key].value_si == parameter.value_si


@pytest.mark.parametrize("name", LINEAR)
def test_a_linear_ship_travels_without_a_change(name, tmp_path):
    ship = swayaw.load_ship(name)
    ship.save(tmp_path / "ship.toml")
    assert swayaw.load_ship(tmp_path / "ship.toml") == ship == pickle.loads(pickle.dumps(ship))


def test_files_of_the_project_are_the_published_ships(source):
    for name in swayaw.published_ships():
        assert swayaw.load_ship(source / "ships" / f"{name}.toml") == swayaw.load_ship(name)


def test_parameters_have_value_unit_and_range(ship):
    rate = ship.parameters["rate_deg_s"]
    assert rate.unit == "deg/s" and rate.range == (0.0, math.inf) and rate.role == "fact"
    assert rate.value_si == math.radians(rate.value)
    N_v = ship.parameters["N_v"]
    assert N_v.role == "coefficient" and N_v.deviation == pytest.approx(0.1 * abs(N_v.value))


def test_other_values_change_nothing_else(ship):
    other = ship.with_values({"N_v": -0.2, "rate_deg_s": 5.0})
    assert other.parameters["N_v"].value == -0.2
    assert other.steering_gear.rate == math.radians(5.0)
    assert other.with_values({k: ship.parameters[k].value for k in ("N_v", "rate_deg_s")}) == ship != other


def test_bad_values_are_refused_in_words(ship):
    with pytest.raises(swayaw.Refusal, match="N_w"):
        ship.with_values({"N_w": 1.0})
    with pytest.raises(ValueError, match=r"length_m in \[particulars\] cannot be -1"):
        ship.with_values({"length_m": -1.0})


def test_effects_are_added_by_id(ship):
    drifting = ship.with_effect("steady_current", current_speed_m_s=0.5, current_to_rad=1.0)
    (effect,) = drifting.effects
    assert effect.numbers == {"current_speed_m_s": 0.5, "current_to_rad": 1.0}
    assert effect == swayaw.Effect("steady_current", current_speed_m_s=0.5, current_to_rad=1.0)
    assert pickle.loads(pickle.dumps(effect)) == effect
    assert swayaw.parse_ship(drifting.text()) == drifting != ship
    assert drifting.without_effects() == ship
    with pytest.raises(swayaw.Refusal, match="has the effect steady_current already"):
        drifting.with_effect(effect)


def test_effects_are_refused_as_in_files(ship):
    with pytest.raises(ValueError, match='there is no effect "steady_wnd"; did you mean "steady_wind"?'):
        swayaw.Effect("steady_wnd")
    with pytest.raises(ValueError, match="steady_wind needs wind_from_rad"):
        swayaw.Effect("steady_wind", wind_speed_m_s=3.0)
    with pytest.raises(ValueError, match="wind_speed_m_s of steady_wind cannot be -3"):
        swayaw.Effect("steady_wind", wind_speed_m_s=-3.0, wind_from_rad=0.0)
    with pytest.raises(ValueError, match="wind_sped_m_s is not a number of steady_wind"):
        swayaw.Effect("steady_wind", wind_sped_m_s=3.0)
    clock = swayaw.Effect("clock_drift", channel="x", at_s=60.0, by_s=3.0)
    assert clock.numbers["by_s"] == 3.0 and clock.numbers["rate"] == 0.0
    with pytest.raises(ValueError, match="a jump needs at_s and by_s"):
        swayaw.Effect("clock_drift", channel="x", by_s=3.0)
    with pytest.raises(ValueError, match="channel_delay needs channel"):
        swayaw.Effect("channel_delay", delay_s=1.0)


@pytest.mark.parametrize("id", swayaw.effect_ids())
def test_every_effect_does_nothing_at_first(id):
    effect = swayaw.effect_named(id)
    assert effect.id == id and effect.is_null and effect.label and effect.law
    assert effect.place in ("air", "water", "force", "actuator", "sensor")


def test_ships_that_are_not_there_are_refused_in_words(tmp_path):
    with pytest.raises(swayaw.Refusal, match="kvlcc2"):
        swayaw.published_ship("kvlcc3")
    with pytest.raises(swayaw.FileError, match="cannot be read"):
        swayaw.load_ship(tmp_path / "none.toml")
    with pytest.raises(swayaw.FileError, match="tanker97"):
        swayaw.published_ship("tanker97")


def test_a_ship_from_main_dimensions():
    ship, estimate = swayaw.estimate_ship(320.0, 58.0, 20.8, 0.81, 7.97, name="like KVLCC2")
    assert ship.model == "mmg" and ship.length == 320.0 and estimate.assumptions
    assert swayaw.turning_circle(ship, math.radians(35)).tactical_diameter == pytest.approx(3.2 * 320, rel=0.3)
    with pytest.raises(swayaw.Refusal):
        swayaw.estimate_ship(320.0, 58.0, 20.8, 0.81, 7.97, trim=2.0)
