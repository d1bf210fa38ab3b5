"""The linear floor: conversions and back, exact responses, matrices for other tools."""

import json
import math
import pickle

import numpy
import pytest
import scipy.linalg
import scipy.signal

import swayaw


@pytest.fixture
def coefficients() -> swayaw.SwayYawCoefficients:
    return swayaw.load_ship("tanker97").coefficients


def test_indices_and_back(coefficients):
    for m in (swayaw.steering_indices(coefficients), swayaw.transfer_functions(coefficients)):
        back = swayaw.coefficients_from(m)
        for name in coefficients._fields:
            assert getattr(back, name) == pytest.approx(getattr(coefficients, name), rel=1e-9)
    indices = swayaw.steering_indices(coefficients)
    constants = swayaw.time_constants(coefficients)
    assert constants.T1 * constants.T2 == pytest.approx(indices.T1T2)
    assert swayaw.first_order_yaw(indices).T == pytest.approx(indices.T1_plus_T2 - indices.T3w)


def test_indices_are_those_of_the_program(program, coefficients):
    told = json.loads(program("indices", "tanker97", "--json"))
    indices = swayaw.steering_indices(coefficients)
    assert [getattr(coefficients, k) for k in ("a1", "b1", "c1", "a2", "b2", "c2")] == [
        told[k] for k in ("a1", "b1", "c1", "a2", "b2", "c2")
    ]
    assert [indices.T3b, indices.T3w, indices.Kb, indices.Kw] == [told[k] for k in ("T3b", "T3w", "Kb", "Kw")]
    assert coefficients.stable == told["stable"] and coefficients.complex_poles == told["complex_poles"]


def test_dimension_and_back(coefficients):
    scale = swayaw.PrimeScale(L=97.4, U=7.2)
    for m in (coefficients, swayaw.steering_indices(coefficients)):
        back = swayaw.to_prime(swayaw.dimensional(m, scale), scale)
        assert list(back._asdict().values()) == pytest.approx(list(m._asdict().values()), rel=1e-14)


def test_hull_and_rudder_come_back(coefficients):
    parts = swayaw.load_ship("tanker97").form
    assert swayaw.coefficients_of(parts).total == coefficients
    for known in ("Y_b", "Y_w", "N_b", "N_w", "c_Ry"):
        back = swayaw.parts_from(coefficients, parts, known)
        assert back.hull.N_w == pytest.approx(parts.hull.N_w, rel=1e-8)
        assert back.rudder.a_H == pytest.approx(parts.rudder.a_H, rel=1e-8)
    with pytest.raises(ValueError, match='"Y_c" is none of Y_b'):
        swayaw.parts_from(coefficients, parts, "Y_c")


def test_elasticities_are_those_of_differences(coefficients):
    indices = swayaw.steering_indices(coefficients)
    elasticity = swayaw.coefficient_elasticities(coefficients)
    for name in ("T3b", "T3w", "Kb", "Kw"):
        up, down = (
            swayaw.coefficients_from(indices._replace(**{name: getattr(indices, name) * f})) for f in (1 + 1e-6, 1 - 1e-6)
        )
        for c in coefficients._fields:
            change = (getattr(up, c) - getattr(down, c)) / getattr(coefficients, c) / 2e-6
            assert elasticity[c][name] == pytest.approx(change, rel=1e-5, abs=1e-6)


def test_the_response_is_that_of_the_matrix_exponential(coefficients):
    s = numpy.linspace(0.0, 20.0, 41)
    exact = swayaw.response(coefficients, swayaw.rudder_step(0.1), s)
    space = coefficients.state_space(heading=True)
    together = numpy.block([[space.A, space.B], [numpy.zeros((1, 4))]])
    for i, time in enumerate(s):
        state = scipy.linalg.expm(together * time) @ numpy.array([0.0, 0.0, 0.0, 0.1])
        assert [exact[k][i] for k in ("beta", "omega", "psi")] == pytest.approx(state[:3], rel=1e-9, abs=1e-12)


def test_scipy_takes_the_matrices(coefficients):
    space = swayaw.dimensional(coefficients, swayaw.PrimeScale(97.4, 7.2)).state_space()
    _, response = scipy.signal.step(space.to_scipy())
    assert response.shape[-1] == 2 and space.states == ("v", "r") and space.unit == "s"
    assert sorted(space.poles.real)[0] < 0.0
    frequency = numpy.logspace(-2, 1, 30)
    scale = swayaw.PrimeScale(1.0, 1.0)
    bode = swayaw.bode(swayaw.transfer_functions(coefficients), "yaw", frequency, scale)
    _, expected = scipy.signal.freqresp(
        scipy.signal.StateSpace(*(numpy.asarray(x) for x in _yaw_alone(coefficients))), frequency
    )
    assert bode["gain"] == pytest.approx(numpy.abs(expected), rel=1e-9)


def _yaw_alone(coefficients):
    space = coefficients.state_space()
    return space.A, space.B, space.C[1:], space.D[1:]


def test_python_control_takes_the_matrices(coefficients):
    pytest.importorskip("control")
    system = coefficients.state_space(heading=True).to_control()
    assert system.state_labels == ["beta", "omega", "psi"]


def test_a_zigzag_is_its_states(coefficients):
    zigzag = swayaw.linear_zigzag(coefficients, math.radians(20), math.radians(20), rate=0.5)
    for reversal in zigzag.reversals:
        at = zigzag.states(coefficients, [reversal.execute, reversal.peak])
        assert abs(at["psi"][0]) == pytest.approx(math.radians(20), rel=1e-9)
        assert at["omega"][1] == pytest.approx(0.0, abs=1e-9)
    assert pickle.loads(pickle.dumps(zigzag)) == zigzag
    run = zigzag.recording(coefficients, swayaw.PrimeScale(97.4, 7.2), step=0.5)
    assert run["r_rad_s"].max() > 0.0


def test_sensitivity_of_the_loop_is_that_of_differences(coefficients):
    indices = swayaw.steering_indices(coefficients)
    question = dict(rudder=math.radians(20), heading=math.radians(20), rate=0.5)
    exact = swayaw.loop_sensitivity(indices, **question)

    def loop(T3b):
        changed = swayaw.coefficients_from(indices._replace(T3b=T3b))
        return swayaw.drift_yaw_loop(changed, swayaw.limit_cycle(changed, **question).zigzag)

    h = 1e-5
    difference = (loop(indices.T3b + h).area - loop(indices.T3b - h).area) / (2.0 * h)
    assert exact.by_T3b.area == pytest.approx(difference, rel=1e-5)


def test_records_are_made_by_position_and_name():
    made = swayaw.FirstOrder(-1.0, T=2.0)
    assert (made.K, made.T) == (-1.0, 2.0) and made == swayaw.FirstOrder(K=-1.0, T=2.0)
    assert repr(made) == "FirstOrder(K=-1.0, T=2.0)"
    for wrong, words in (
        (dict(K=1.0), "FirstOrder needs T"),
        (dict(K=1.0, T=1.0, L=3.0), "FirstOrder has no field L"),
        (dict(K="x", T=1.0), "K must be float, got 'x'"),
    ):
        with pytest.raises(TypeError, match=words):
            swayaw.FirstOrder(**wrong)
    with pytest.raises(AttributeError):
        made.K = 3.0
