"""Comparison and diagnosis: the same answers as the program, progress, Ctrl-C, other threads."""

import json
import math
import pickle
import subprocess
import sys
import textwrap
import threading

import numpy
import pytest

import swayaw


def test_a_comparison_is_that_of_the_program(program, source, model, recorded):
    files = [source / "examples/recordings" / run.name for run in recorded]
    told = json.loads(program("compare", "kvlcc2_l7", *files, "--json"))
    comparisons = [swayaw.compare(model, run) for run in recorded]
    for comparison, run in zip(comparisons, told["runs"]):
        assert [(q["quantity"], q["window_rms"], q["bias"]) for q in run["quantities"]] == [
            (e.quantity, e.window_rms, e.bias) for e in comparison.errors
        ]
    assert swayaw.compare_verdict(comparisons) == told["verdict"]
    assert comparisons[0]["yaw_rate"].normalised > 0.0
    assert pickle.loads(pickle.dumps(comparisons[0])) == comparisons[0]
    assert "yaw rate" in comparisons[0]._repr_html_()


@pytest.fixture(scope="module")
def diagnosis(source):
    """Of the two example recordings, whose rudder is 18 % weaker than in the ship file."""
    folder = source / "examples" / "recordings"
    runs = [swayaw.read_csv(folder / name) for name in ("weak_rudder_zz10_10.csv", "weak_rudder_turn35.csv")]
    heard, elsewhere = [], []
    stop = threading.Event()

    def count():
        while not stop.wait(0.01):
            elsewhere.append(1)

    other = threading.Thread(target=count)
    other.start()
    try:
        result = swayaw.diagnose(
            swayaw.published_ship("kvlcc2_l7"), runs, progress=heard.append, pictures=True
        )
    finally:
        stop.set()
        other.join()
    assert len(elsewhere) > 20  # another thread went on meanwhile
    return result, heard


def test_a_diagnosis_is_that_of_the_program(diagnosis, program, source):
    files = [source / "examples/recordings" / f"weak_rudder_{name}.csv" for name in ("zz10_10", "turn35")]
    told = json.loads(program("diagnose", "kvlcc2_l7", *files, "--json"))
    result, _ = diagnosis
    assert (result.verdict, result.words) == (told["verdict"], told["words"])
    assert result.discrepancy._asdict() == told["discrepancy"]
    assert [(c.effect, c.log_evidence_gain) for c in result.candidates] == [
        (c["effect"], c["log_evidence_gain"]) for c in told["candidates"]
    ]
    for budget in result.budget:
        shown = told["budget"][budget.quantity]
        assert budget.shares == {name: shown[name] for name in budget.shares}


def test_a_diagnosis_names_the_weak_rudder(diagnosis):
    result, heard = diagnosis
    assert "18 % less rudder force" in result.words and result.moved.part == "rudder"
    assert len(heard) > 3 and all(isinstance(words, str) for words in heard)
    assert result.discrepancy.after <= result.discrepancy.given
    for budget in result.budget:
        assert sum(budget.shares.values()) == pytest.approx(1.0)


def test_a_diagnosis_travels_and_shows_itself(diagnosis):
    result, _ = diagnosis
    assert pickle.loads(pickle.dumps(result)) == result
    assert "The force that the model as given lacks" in result._repr_html_()
    assert swayaw.parse_ship(result.improved.text()) == result.improved


def test_a_current_is_found_in_runs_that_were_sailed_in_one(model):
    sailed = model.with_effect("steady_current", current_speed_m_s=0.15, current_to_rad=1.0)
    rng = numpy.random.default_rng(1)
    runs = []
    for angle in (10, 20):
        run = swayaw.zigzag(sailed, math.radians(angle), math.radians(angle), step=0.5).run
        for column, deviation in {"x_m": 0.02, "y_m": 0.02, "psi_rad": 1e-3, "r_rad_s": 3e-4, "u_m_s": 2e-3}.items():
            run[column] += deviation * rng.standard_normal(len(run))
        run.name = f"zz{angle}"
        runs.append(run)
    result = swayaw.diagnose(model, runs)
    (found,) = result.effects
    assert found.effect.id == "steady_current" and found.effect in result.improved.effects
    for p, truth in zip(found.parameters, (0.15, 1.0)):
        assert p.value == pytest.approx(truth, abs=4.0 * p.standard_error)
    assert pickle.loads(pickle.dumps(result)) == result
    assert "steady current" in result._repr_html_()
    assert swayaw.frame_of(result.candidates).loc[0, "effect"] == "steady_current"


def test_a_listener_ends_a_diagnosis_with_what_is_known(model, recorded):
    told = []
    result = swayaw.diagnose(model, recorded, progress=lambda words: told.append(words) or len(told) < 2)
    assert result.verdict in ("missing_physics", "nothing_missing", "unexplained")


def test_no_runs_are_refused_in_words(model):
    with pytest.raises(swayaw.Refusal):
        swayaw.diagnose(model, [])


def test_ctrl_c_ends_a_diagnosis(source):
    """In a process of its own, which interrupts itself at the first word of the work."""
    script = f"""
        import os, signal, swayaw
        folder = {str(source / 'examples' / 'recordings')!r}
        runs = [swayaw.read_csv(f"{{folder}}/weak_rudder_{{n}}.csv") for n in ("zz10_10", "turn35")]
        interrupt = lambda words: os.kill(os.getpid(), signal.SIGINT)
        try:
            swayaw.diagnose(swayaw.published_ship("kvlcc2_l7"), runs, progress=interrupt)
        except KeyboardInterrupt:
            print("interrupted")
    """
    ended = subprocess.run([sys.executable, "-c", textwrap.dedent(script)], capture_output=True, text=True, timeout=120)
    assert ended.stdout == "interrupted\n", ended.stderr


def test_a_fleet_is_that_of_the_program(program, source, tmp_path):
    day = "# start_utc = \"2026-{}T08:00:00Z\"\n# vessel = \"{}\"\n{}"
    text = (source / "examples/recordings/weak_rudder_zz10_10.csv").read_text(encoding="utf-8")
    files = [tmp_path / f"{vessel}_{date}.csv" for vessel in ("athena", "boreas") for date in ("01-05", "02-03")]
    for file in files:
        vessel, date = file.stem.split("_")
        file.write_text(day.format(date, vessel, text), encoding="utf-8")
    told = json.loads(program("fleet", "kvlcc2_l7", *files, "--json"))
    runs = [swayaw.read_csv(file) for file in files]
    assert [swayaw.remark_of(run, "vessel") for run in runs] == ["athena", "athena", "boreas", "boreas"]
    assert swayaw.date_text(swayaw.start_utc(runs[1]) / 86400.0) == "2026-02-03"
    result = swayaw.diagnose_fleet(
        swayaw.published_ship("kvlcc2_l7"),
        [swayaw.FleetRun(swayaw.remark_of(run, "vessel"), run) for run in runs],
        progress=False,
    )
    assert result.words == told["words"]
    assert [c.found for c in result.shared] == [c["found"] for c in told["shared"]]
    assert [v.errors.own for v in result.vessels] == [v["errors"]["own"] for v in told["vessels"]]
    assert all(v.changes == [] for v in result.vessels)  # every day is the same recording
    assert pickle.loads(pickle.dumps(result)).words == result.words
    with pytest.raises(swayaw.Refusal, match="start_utc"):
        swayaw.diagnose_fleet(
            swayaw.published_ship("kvlcc2_l7"), [swayaw.FleetRun("a", swayaw.parse_csv(text))], progress=False
        )
