"""Long work tells a notebook what it does, in one line, unless it is told to say nothing."""

import sys
import types

import pytest

import swayaw
from swayaw import notebook


@pytest.fixture
def shown(monkeypatch):
    """What a notebook shows; its IPython stands in for the real one."""
    lines = []

    class Handle:
        def update(self, bundle, raw):
            lines.append(bundle["text/plain"])

    def display(bundle, raw, display_id):
        lines.append(bundle["text/plain"])
        return Handle()

    ipython, inside = types.ModuleType("IPython"), types.ModuleType("IPython.display")
    ipython.get_ipython = lambda: types.SimpleNamespace(kernel=object())
    inside.display = display
    monkeypatch.setitem(sys.modules, "IPython", ipython)
    monkeypatch.setitem(sys.modules, "IPython.display", inside)
    return lines


def test_a_diagnosis_shows_a_line(shown, model, recorded):
    swayaw.diagnose(model, recorded[:1], most_effects=1)
    assert len(shown) > 2 and shown[0] == "diagnose, 0 s: …" and shown[-1].endswith("done")
    assert all(line.startswith("diagnose, ") for line in shown)


def test_a_fit_and_a_tuning_show_a_line(shown, model, recorded):
    swayaw.fit_trajectories(model, recorded[:1], ["N_v"], most_iterations=2)
    assert shown[1].startswith("fit_trajectories, 0 s: iteration ")
    shown.clear()
    measured = swayaw.measured_indices(model.length, turns=[{"rudder_deg": 35, "advance_L": 3.0}])
    swayaw.tune(model, measured, ["N_v"])
    assert "turning circles" in shown[1] and shown[-1].startswith("tune, ")


def test_nothing_is_shown_where_it_is_not_wanted(shown, model, recorded, monkeypatch):
    told = []
    swayaw.fit_trajectories(model, recorded[:1], ["N_v"], most_iterations=2, progress=lambda *_: told.append(1))
    swayaw.fit_trajectories(model, recorded[:1], ["N_v"], most_iterations=2, progress=False)
    assert told and not shown
    sys.modules["IPython"].get_ipython = lambda: None
    assert notebook.line("diagnose") is None
    sys.modules["IPython"].get_ipython = lambda: types.SimpleNamespace()  # of a terminal
    assert notebook.line("diagnose") is None
