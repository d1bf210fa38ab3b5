"""Regression: the law of least squares, priors, constraints, and what data do not tell."""

import pickle

import numpy
import pytest

import swayaw


@pytest.fixture
def data():
    rng = numpy.random.default_rng(5)
    X = rng.standard_normal((400, 3))
    return X, X @ [1.0, -2.0, 0.5] + 0.1 * rng.standard_normal(400)


def test_least_squares_are_those_of_numpy(data):
    X, y = data
    fit = swayaw.regress(X, y, ["a", "b", "c"])
    truth, squares, *_ = numpy.linalg.lstsq(X, y, rcond=None)
    assert [c.estimate.value for c in fit.coefficients] == pytest.approx(truth, rel=1e-12)
    covariance = numpy.linalg.inv(X.T @ X) * squares[0] / (400 - 3)
    assert fit.covariance == pytest.approx(covariance, rel=1e-9)
    assert fit.residuals == pytest.approx(y - X @ truth, abs=1e-12)
    assert fit["b"].estimate.value == fit.coefficients[1].estimate.value and fit.status == "converged"
    assert numpy.diag(swayaw.correlation(fit)) == pytest.approx(numpy.ones(3))
    again = pickle.loads(pickle.dumps(fit))
    assert again == fit and again.covariance.tobytes() == fit.covariance.tobytes()
    with pytest.raises(swayaw.Refusal, match="d"):
        fit["d"]


def test_what_is_known_counts(data):
    X, y = data
    held = swayaw.regress(X, y, constraints=[([("b0", 1.0), ("b1", 1.0)], 0.0)])
    assert held["b0"].estimate.value == pytest.approx(-held["b1"].estimate.value, rel=1e-12)
    sure = swayaw.regress(X, y, ["a", "b", "c"], priors={"a": (3.0, 1e-9)})
    assert sure["a"].estimate.value == pytest.approx(3.0, abs=1e-6)
    small = swayaw.regress(X, y, ridge=1e6)
    assert abs(small["b1"].estimate.value) < 0.01


def test_correlated_residuals_widen_the_errors(data):
    X, _ = data
    rng = numpy.random.default_rng(6)
    e = numpy.zeros(400)
    for i in range(1, 400):
        e[i] = 0.9 * e[i - 1] + 0.1 * rng.standard_normal()
    ones = numpy.ones((400, 1))
    plain = swayaw.regress(ones, 1.0 + e)["b0"].estimate.standard_error
    for how in ({"standard_errors": "newey_west"}, {"residuals": "autoregressive"}):
        fit = swayaw.regress(ones, 1.0 + e, **how)
        assert fit["b0"].estimate.standard_error > 2.0 * plain
    assert fit.autoregression[0] == pytest.approx(0.9, abs=0.1)


def test_errors_of_features_are_taken_off():
    rng = numpy.random.default_rng(8)
    x = rng.standard_normal((5000, 1))
    seen, y = x + 0.5 * rng.standard_normal((5000, 1)), 2.0 * x[:, 0] + 0.1 * rng.standard_normal(5000)
    assert swayaw.regress(seen, y)["b0"].estimate.value < 1.75
    right = swayaw.regress(seen, y, feature_covariance=[[0.25, 0.0], [0.0, 0.01]])
    assert right["b0"].estimate.value == pytest.approx(2.0, abs=0.06) and right["b0"].attenuation < -0.2


def test_what_data_do_not_tell_is_named_and_nonsense_refused(data):
    X, y = data
    twice = numpy.column_stack([X[:, 0], X[:, 0]])
    fit = swayaw.regress(twice, y, ["Y_v", "Y_r"])
    assert fit.status == "rank deficient" and "Y_v" in fit.undetermined[0].words
    with pytest.raises(ValueError, match="two dimensions"):
        swayaw.regress(y, y)
    with pytest.raises(ValueError):
        swayaw.regress(X, y[:-1])
    with pytest.raises(swayaw.Refusal, match="z"):
        swayaw.regress(X, y, priors={"z": (0.0, 1.0)})
