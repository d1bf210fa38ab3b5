"""Unknowns of any kind: a hidden coefficient and a hidden current, found together; the force that a model lacks."""

import math
import pickle

import numpy
import pytest

import swayaw


@pytest.fixture(scope="module")
def sailed():
    """The 7 m model of KVLCC2 with 10 % more of N_r in a current, recorded with noise."""
    ship = swayaw.published_ship("kvlcc2_l7")
    truth = ship.with_values({"N_r": 1.1 * ship.parameters["N_r"].value})
    truth = truth.with_effect("steady_current", current_speed_m_s=0.1, current_to_rad=0.0)
    run = swayaw.zigzag(truth, math.radians(20), math.radians(20), step=0.5).run
    rng = numpy.random.default_rng(2)
    noise = {"x_m": 0.02, "y_m": 0.02, "psi_rad": 1e-3, "r_rad_s": 3e-4, "u_m_s": 2e-3, "v_m_s": 2e-3}
    for column, deviation in noise.items():
        run[column] += deviation * rng.standard_normal(len(run))
    return ship, run


def ship_with(ship):
    def she(values, run):
        other = ship.with_values({"N_r": ship.parameters["N_r"].value * (1.0 + values["more"])})
        north = values["north"]
        return other.with_effect(
            "steady_current", current_speed_m_s=abs(north), current_to_rad=0.0 if north >= 0.0 else math.pi
        )

    return she


def test_unknowns_are_found_with_their_errors(sailed):
    ship, run = sailed
    unknowns = [swayaw.Unknown("more", deviation=0.2, step=0.02), swayaw.Unknown("north", deviation=0.2, step=0.02)]
    fit = swayaw.map_fit(ship, [run], unknowns, ship_with(ship), lean=True)
    error = numpy.sqrt(numpy.diag(fit.covariance))
    assert numpy.all(numpy.abs(fit.point - [0.1, 0.1]) < 4.0 * error) and error[1] < 0.01
    assert numpy.linalg.inv(fit.covariance) == pytest.approx(fit.information + numpy.eye(2) / 0.04, rel=1e-6)
    assert pickle.loads(pickle.dumps(fit)) == fit
    alone = swayaw.map_fit(ship, [run], unknowns[:1], lambda values, _: ship_with(ship)({**values, "north": 0.0}, _), lean=True)
    assert fit.log_evidence > alone.log_evidence + 10.0


def test_what_the_function_raises_ends_the_fit(sailed):
    ship, run = sailed

    def fails(values, run):
        raise LookupError("of the function")

    with pytest.raises(LookupError, match="of the function"):
        swayaw.map_fit(ship, [run], [swayaw.Unknown("a")], fails)
    with pytest.raises(ValueError, match="deviation of a must be positive"):
        swayaw.map_fit(ship, [run], [swayaw.Unknown("a", deviation=0.0)], fails)
    with pytest.raises(ValueError, match="there must be an unknown"):
        swayaw.map_fit(ship, [run], [], fails)


def test_the_force_that_a_model_lacks_is_that_which_acted(sailed):
    ship, _ = sailed
    more = 1.3
    truth = ship.with_values({"N_r": more * ship.parameters["N_r"].value})
    run = swayaw.zigzag(truth, math.radians(20), math.radians(20), step=0.25).run
    missing = swayaw.missing_force(ship, run, swayaw.Noise(scale=10.0))
    assert len(missing) == len(run)
    at = numpy.array([m.motion.r for m in missing])
    lacks = []
    for m, delta, rev in zip(missing, run["delta_rad"], run["rev_s"]):
        state, controls = swayaw.ShipState(0.0, 0.0, 0.0, m.motion), swayaw.Controls(delta=delta, rev=rev)
        lacks.append(swayaw.force_breakdown(truth, state, controls).total.N - swayaw.force_breakdown(ship, state, controls).total.N)
    found = numpy.array([m.force.N for m in missing])
    assert numpy.ptp(at) > 0.01 and numpy.corrcoef(found[20:-20], numpy.array(lacks)[20:-20])[0, 1] > 0.9
    assert swayaw.ordinary_force(ship).N > 0.0
    assert swayaw.process_noise(ship, swayaw.Noise(scale=2.0)).v == pytest.approx(2.0 * swayaw.process_noise(ship, swayaw.Noise(scale=1.0)).v)


def test_zigzags_are_told_beside_those_of_the_model(sailed):
    ship, run = sailed
    (view,) = swayaw.linear_view(ship, [run])
    assert view.amplitude == pytest.approx(math.radians(20), rel=1e-6) and view.recorded.K != view.model.K
    assert isinstance(swayaw.linear_words([view]), str)
    picture = swayaw.run_picture(ship, ship, ship, run)
    assert len(picture.recorded) <= 500 and picture.given == picture.after
