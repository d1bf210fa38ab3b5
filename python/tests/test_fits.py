"""Checks, trials, states and fits of recordings."""

import json
import math
import pickle

import numpy
import pytest

import swayaw


NOISE = {"x_m": 0.02, "y_m": 0.02, "psi_rad": 1e-3, "r_rad_s": 3e-4, "u_m_s": 2e-3, "v_m_s": 2e-3}


@pytest.fixture(scope="module")
def noisy():
    """Two zigzags of the 7 m model of KVLCC2 with noise of instruments, and her."""
    ship = swayaw.published_ship("kvlcc2_l7")
    rng = numpy.random.default_rng(7)
    runs = []
    for angle in (10, 20):
        run = swayaw.zigzag(ship, math.radians(angle), math.radians(angle), step=0.25).run
        for column, deviation in NOISE.items():
            run[column] += deviation * rng.standard_normal(len(run))
        run.name = f"zz{angle}"
        runs.append(run)
    return ship, runs


def test_a_clean_run_has_no_mistake_and_a_turned_one_has(noisy):
    _, runs = noisy
    check = swayaw.check(runs[0])
    assert check.mistake is None and check.run == "zz10"
    turned = pickle.loads(pickle.dumps(runs[0]))
    turned["r_rad_s"] = -turned["r_rad_s"]
    found = swayaw.check(turned).mistake
    assert (found.channel, found.kind, found.is_mistake) == ("r", "sign", True) and found.remedy
    assert pickle.loads(pickle.dumps(check)) == check
    with pytest.raises(swayaw.Refusal):
        swayaw.check(swayaw.Recording([0.0, 1.0], {"psi_rad": [0.0, 0.1], "delta_rad": [0.0, 0.0]}))


def test_a_zero_is_told_and_mended(noisy):
    _, runs = noisy
    shifted = pickle.loads(pickle.dumps(runs[1]))
    shifted["r_rad_s"] += 0.004
    check = swayaw.check(shifted)
    (zero,) = [e for e in check.told if (e.channel, e.kind) == ("r", "zero")]
    assert zero.value == pytest.approx(0.004, abs=4 * zero.standard_error) and "yaw rate" in zero.words
    mended = swayaw.repaired(shifted, check)
    assert numpy.mean(mended["r_rad_s"] - runs[1]["r_rad_s"]) == pytest.approx(0.0, abs=4 * zero.standard_error)
    (group,) = swayaw.check_groups([check])
    assert group.runs == ["zz20"]


def test_a_trial_tells_what_was_sailed(noisy):
    ship, runs = noisy
    truth = swayaw.zigzag(ship, math.radians(10), math.radians(10))
    trial = swayaw.trial(runs[0], ship)
    assert trial.manoeuvre.name == "zigzag 10/10"
    peaks = [(told, true) for told, true in zip(trial.zigzag.reversals, truth.reversals) if told.overshoot]
    assert len(peaks) >= 3
    for told, true in peaks:
        assert told.overshoot.value == pytest.approx(true.overshoot, abs=5 * told.overshoot.standard_error)
    assert trial.steering.least_squares.K.value > 0.0
    assert pickle.loads(pickle.dumps(trial)) == trial
    assert "overshoot" in trial._repr_html_()
    assert swayaw.trial_summary([trial]).any


def test_a_trial_is_that_of_the_program(program, source, recorded, model):
    file = source / "examples/recordings/weak_rudder_zz10_10.csv"
    told = json.loads(program("trial", file, "--ship", "kvlcc2_l7", "--json"))["runs"][0]
    trial = swayaw.trial(recorded[0], model)
    assert [math.degrees(r.overshoot.value) for r in trial.zigzag.reversals if r.overshoot] == pytest.approx(
        [x["value"] for x in told["overshoot_deg"]], rel=1e-14
    )
    assert [c.value.value for c in trial.imo] == [c["value"]["value"] for c in told["imo"]]


def test_states_are_those_that_were_sailed(noisy):
    ship, runs = noisy
    truth = swayaw.zigzag(ship, math.radians(20), math.radians(20), step=0.25).run
    estimate = swayaw.estimate_states(ship, runs[1])
    assert estimate.states.shape == (len(runs[1]), 9) and estimate.covariances.shape == (len(runs[1]), 9, 9)
    assert estimate.converged and set(estimate.noise) >= {"psi", "r"}
    error = estimate.states[:, 2] - truth["psi_rad"]
    assert numpy.sqrt(numpy.mean(error**2)) < 5e-4 < 1e-3
    deviation = numpy.sqrt(estimate.covariances[:, 2, 2])
    assert numpy.mean(numpy.abs(error) < 3.0 * deviation) > 0.95
    again = pickle.loads(pickle.dumps(estimate))
    assert again == estimate and again.states.tobytes() == estimate.states.tobytes()
    assert again.recording(runs[1]) == estimate.recording(runs[1])
    assert estimate.recording(runs[1])["psi_rad"] == pytest.approx(estimate.states[:, 2], abs=1e-12)
    with pytest.raises(ValueError, match='"yaw" is none of x, y, psi'):
        swayaw.estimate_states(ship, runs[1], noise={"yaw": 1e-3})


def test_forces_tell_coefficients(noisy):
    ship, runs = noisy
    fit = swayaw.fit_forces(ship, runs, ["N_v", "N_r"])
    for name in ("N_v", "N_r"):
        c = fit.coefficients[name]
        assert c.estimate.value == pytest.approx(ship.parameters[name].value, rel=0.1)
        assert c.estimate.verdict == "determined"
        assert fit.ship.parameters[name].value == pytest.approx(c.estimate.value)
    assert fit.range.rudder == pytest.approx(math.radians(20), rel=1e-6)
    again = pickle.loads(pickle.dumps(fit))
    assert again == fit and again.stability == fit.stability
    assert again.equations[0].fit.covariance.tobytes() == fit.equations[0].fit.covariance.tobytes()
    some = {r.runs: r.values for r in swayaw.resample(ship, runs, fit, ["N_v", "N_r"])}
    assert some["all runs"] == pytest.approx([fit.coefficients[n].estimate.value for n in ("N_v", "N_r")], rel=1e-12)
    assert some["all but zz10"] != some["all but zz20"]
    assert some["all but zz10"] == pytest.approx(some["all but zz20"], rel=1e-2)
    with pytest.raises(swayaw.Refusal, match="N_w"):
        swayaw.fit_forces(ship, runs, ["N_w"])


def test_trajectories_tell_coefficients_and_their_progress(noisy):
    ship, runs = noisy
    wrong = ship.with_values({"N_v": 1.1 * ship.parameters["N_v"].value, "N_r": 0.9 * ship.parameters["N_r"].value})
    heard = []
    fit = swayaw.fit_trajectories(
        wrong, runs, ["N_v", "N_r"], progress=lambda i, ll, change, values: heard.append((i, sorted(values)))
    )
    assert fit.status == "converged" and heard[0][1] == ["N_r", "N_v"]
    for p in fit.parameters:
        truth = ship.parameters[p.name].value_si
        assert p.estimate.value == pytest.approx(truth, abs=4.0 * p.estimate.standard_error)
    assert fit.covariance.shape == (2, 2)
    again = pickle.loads(pickle.dumps(fit))
    assert again == fit and again.covariance.tobytes() == fit.covariance.tobytes()
    assert again.noise == fit.noise and again.ship == fit.ship


def test_a_listener_can_end_a_fit_and_may_fail(noisy):
    ship, runs = noisy
    assert swayaw.fit_trajectories(ship, runs, ["N_v"], progress=lambda *_: False).status == "stopped"

    def fails(*_):
        raise LookupError("of the listener")

    with pytest.raises(LookupError, match="of the listener"):
        swayaw.fit_trajectories(ship, runs, ["N_v"], progress=fails)


def test_a_linear_ship_tells_her_coefficients():
    ship = swayaw.load_ship("tanker97")
    zigzag = swayaw.linear_zigzag(ship.coefficients, math.radians(20), math.radians(20), rate=0.5)
    run = zigzag.recording(ship.coefficients, ship.scale(ship.service_speed), step=0.5)
    rng = numpy.random.default_rng(3)
    run["psi_rad"] += 1e-4 * rng.standard_normal(len(run))
    run["r_rad_s"] += 1e-5 * rng.standard_normal(len(run))
    run["v_m_s"] += 1e-3 * rng.standard_normal(len(run))
    fit = swayaw.fit_linear([run], ship.length, disturbances=False)
    for name in ("a2", "b2", "c2"):
        told = getattr(fit.coefficients, name)
        assert told.value == pytest.approx(getattr(ship.coefficients, name), rel=0.01)
    assert fit.stable and fit.scale.L == ship.length
    again = pickle.loads(pickle.dumps(fit))
    assert again == fit and again.covariance.tobytes() == fit.covariance.tobytes()
    assert swayaw.nomoto_zigzag(run).K < 0.0


def test_forces_of_a_run_are_those_of_the_ship(noisy):
    ship, runs = noisy
    estimate = swayaw.estimate_states(ship, runs[1])
    forces = swayaw.inverse_dynamics(ship, runs[1], estimate)
    assert [f.time for f in forces] == list(estimate.time)
    (middle,) = [f for f in forces if f.time == 20.0]
    at = numpy.searchsorted(estimate.time, 20.0)
    _, _, _, u, v, r, *_ = estimate.states[at]
    state = swayaw.ShipState(0.0, 0.0, 0.0, swayaw.PlanarMotion(u, v, r))
    controls = swayaw.Controls(delta=runs[1]["delta_rad"][at], rev=runs[1]["rev_s"][at])
    total = swayaw.force_breakdown(ship, state, controls).total
    error = math.sqrt(middle.damping.covariance[2, 2])
    assert middle.damping.force.N == pytest.approx(total.N, abs=5.0 * error)
    assert pickle.loads(pickle.dumps(middle)) == middle


def test_overshoots_are_those_that_were_sailed(noisy):
    ship, runs = noisy
    order = swayaw.zigzag_order(runs[0])
    assert order == swayaw.ZigzagOrder(math.radians(10), math.radians(10), "starboard")
    peaks = swayaw.recorded_overshoots(runs[0], order)
    truth = [r.overshoot for r in swayaw.zigzag(ship, order.rudder, order.heading).reversals]
    assert peaks[:3] == pytest.approx(truth[:3], abs=5e-3)
    assert swayaw.simulated_overshoots(ship, runs[0], order, 3) == pytest.approx(truth[:3], abs=5e-3)
