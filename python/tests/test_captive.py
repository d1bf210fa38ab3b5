"""Captive tests: a model towed by one ship tells her coefficients to another."""

import math
import pickle

import pytest

import swayaw


@pytest.fixture(scope="module")
def ship():
    return swayaw.published_ship("kvlcc2_pi")


@pytest.fixture(scope="module")
def points(ship, tmp_path_factory):
    """Static drift and rudder angles of the ship herself, in a file."""
    speed = ship.service_speed
    straight = swayaw.self_propulsion(ship)
    thrust = straight.thrust.port + straight.thrust.starboard
    rows = ["run,test_type,U_m_s,beta_deg,r_prime,delta_deg,thrust_N,X_N,Y_N,N_N_m"]
    scheme = [("static_drift", beta, 0) for beta in (-8, -6, -4, -2, 0, 2, 4, 6, 8)]
    scheme += [("static_rudder", 0, delta) for delta in (-20, -10, 10, 20)]
    for number, (test, beta, delta) in enumerate(scheme):
        b = math.radians(beta)
        motion = swayaw.PlanarMotion(speed * math.cos(b), -speed * math.sin(b), 0.0)
        controls = straight._replace(delta=math.radians(delta))
        moment = swayaw.CaptiveMoment(motion, controls=controls)
        force = swayaw.captive_force(ship, swayaw.CaptivePoint("", [], [moment], swayaw.PlanarForce(0.0, 0.0, 0.0)))
        rows.append(f"{number},{test},{speed!r},{beta},0,{delta},{thrust!r},{force.X!r},{force.Y!r},{force.N!r}")
    file = tmp_path_factory.mktemp("captive") / "tests.csv"
    file.write_text("\n".join(rows) + "\n", encoding="utf-8")
    return swayaw.read_captive(file, ship.length)


def test_points_are_those_of_the_file(points, ship):
    assert len(points) == 13 and points[0].tests == ["static_drift"]
    drift = [swayaw.drift_angle(p.moments[0].motion) for p in points[:9]]
    assert [math.degrees(b) for b in drift] == pytest.approx([-8, -6, -4, -2, 0, 2, 4, 6, 8])
    few = swayaw.selected(points, swayaw.CaptiveSelection(max_drift=math.radians(5), max_rudder=0.01))
    assert [p.run for p in few] == ["2", "3", "4", "5", "6"]
    assert swayaw.captive_error(ship, points).rms.Y < 1e-9
    assert pickle.loads(pickle.dumps(points)) == points


def test_coefficients_of_another_ship_are_found(points, ship):
    wrong = ship.with_values({name: 0.8 * ship.parameters[name].value for name in ("Y_v", "N_v")})
    before = swayaw.captive_error(wrong, points)
    assert before.relative.N > 0.05
    still = swayaw.CaptiveSelection(["static_drift"])
    plan = swayaw.CaptivePlan([swayaw.CaptiveStep(still, "Y", ["Y_v"]), swayaw.CaptiveStep(still, "N", ["N_v"])],
                              swayaw.CaptiveSelection(["static_rudder"]))
    fit = swayaw.fit_captive(wrong, points, plan)
    for name in ("Y_v", "N_v"):
        assert fit.ship.parameters[name].value == pytest.approx(ship.parameters[name].value, rel=1e-6)
    assert fit.steps[0].points == 9 and fit.validation.relative.N < 1e-6
    assert pickle.loads(pickle.dumps(fit)) == fit


def test_the_usual_plan_takes_what_was_tested(points, ship):
    plan = swayaw.captive_plan(ship, points, "linear", math.radians(10))
    assert plan.steps and all("static" in test for step in plan.steps for test in step.points.tests)


def test_a_cell_that_is_no_number_is_named(tmp_path):
    file = tmp_path / "bad.csv"
    file.write_text("test_type,U_m_s,beta_deg,r_prime,delta_deg,rev_s,Y_prime\nstatic_drift,1.0,x,0,0,10,0.1\n")
    with pytest.raises(swayaw.FileError, match=r"bad.csv:2"):
        swayaw.read_captive(file, 7.0)
    with pytest.raises(swayaw.Refusal, match="no Y was measured"):
        swayaw.fit_captive(swayaw.published_ship("kvlcc2_pi"), [],
                           swayaw.CaptivePlan([swayaw.CaptiveStep(swayaw.CaptiveSelection(), "Y", ["Y_v"])]))
