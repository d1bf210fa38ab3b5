"""Figures and pages of notebooks can be made of whatever has them."""

import math

import matplotlib.pyplot as plt
import pytest

import swayaw


@pytest.fixture(autouse=True)
def closed():
    yield
    plt.close("all")


def test_manoeuvres_have_figures_and_pages(ship, zigzag):
    circle = swayaw.turning_circle(ship, math.radians(35), "port")
    spiral = swayaw.spiral(ship, math.radians(15), math.radians(5))
    assert len(zigzag.plot().lines) >= 3
    assert circle.plot().get_aspect() == 1.0
    assert spiral.plot().get_ylabel() == "yaw rate, deg/s"
    assert len(zigzag.run.plot()) == len(zigzag.run.columns)
    for result in (zigzag, circle, swayaw.imo_criteria(ship), swayaw.williamson_turn(ship), swayaw.pull_out(ship, 0.3)):
        assert result._repr_html_().startswith("<table>")
    assert "4.836" in zigzag._repr_html_() and "pass" in swayaw.imo_criteria(ship)._repr_html_()


def test_recorded_runs_have_figures(model, recorded):
    comparison = swayaw.compare(model, recorded[0])
    assert len(comparison.plot()) >= 3
    assert swayaw.trial(recorded[0], model).plot(recorded[0]).get_legend() is not None
    assert swayaw.check(recorded[0])._repr_html_()


def test_a_diagnosis_has_figures(model, recorded):
    result = swayaw.diagnose(model, recorded, pictures=True)
    assert result.plot().shape == (2, 2)
    assert swayaw.figures.budget(result).get_ylabel() == "% of its mean square"
    assert result.train_pictures[0].plot().get_title() == recorded[0].name
    with pytest.raises(ValueError, match="pictures=True"):
        result._replace(train_pictures=[]).plot()


def test_a_loop_has_a_figure():
    ship = swayaw.load_ship("tanker97")
    zigzag = swayaw.limit_cycle(ship.coefficients, math.radians(20), math.radians(20), rate=0.5).zigzag
    assert swayaw.figures.drift_yaw_loop(ship.coefficients, zigzag).get_ylabel() == "rL/U"
