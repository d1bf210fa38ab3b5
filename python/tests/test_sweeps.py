"""Sweeps from Python: the same results as the program's, by threads and by a Dask cluster, and resumed by either."""

import json
import pathlib
import sqlite3

import pytest

import swayaw

PLAN = 'task = "zigzag 10/10"\nships = ["kvlcc2"]\ndraws = 40000\nseed = 3\n[vary]\nN_v = { relative_sd = 0.05 }\n'


@pytest.fixture
def plan(tmp_path) -> pathlib.Path:
    file = tmp_path / "plan.toml"
    file.write_text(PLAN, encoding="utf-8")
    return file


def numbers(folder: pathlib.Path) -> list:
    """All blocks to the last bit."""
    with sqlite3.connect(folder / "sweep.sqlite") as results:
        return results.execute("SELECT first, count, numbers FROM block ORDER BY first").fetchall()


def test_threads_and_program_end_with_the_same_bits(plan, tmp_path, program):
    heard = []
    store = swayaw.sweep(plan, tmp_path / "threads", progress=lambda done, of: heard.append((done, of)))
    assert heard[-1][0] == heard[-1][1] and store.rest == []
    told = json.loads(program("sweep", plan, "--out", tmp_path / "program", "--json"))
    assert numbers(tmp_path / "threads") == numbers(tmp_path / "program")
    work = swayaw.SweepWork(plan)
    assert work.items == told["items"] == 40000
    overshoot = work.columns.index("overshoot_1_deg")
    assert store.column(0, overshoot).mean() == pytest.approx(
        next(c["mean"] for c in told["columns"] if c["column"] == "overshoot_1_deg"), rel=1e-12
    )


def test_the_module_goes_on_where_it_was_ended(plan, tmp_path):
    work = swayaw.SweepWork(plan)
    store = swayaw.SweepStore(tmp_path / "part", work)
    some = store.rest[::2]
    store.write([work.block(place) for place in some])
    del store
    assert swayaw.SweepStore(tmp_path / "part", work).rest == [k for k in range(work.blocks) if k not in some]
    swayaw.sweep(plan, tmp_path / "part")
    swayaw.sweep(plan, tmp_path / "whole")
    assert numbers(tmp_path / "part") == numbers(tmp_path / "whole")


def test_a_cluster_of_two_workers_ends_with_the_same_bits(plan, tmp_path):
    distributed = pytest.importorskip("distributed")
    with distributed.LocalCluster(
        n_workers=2, threads_per_worker=1, dashboard_address=None, host="127.0.0.1"
    ) as cluster, distributed.Client(cluster) as client:
        swayaw.sweep(plan, tmp_path / "cluster", client=client)
    swayaw.sweep(plan, tmp_path / "threads")
    assert numbers(tmp_path / "cluster") == numbers(tmp_path / "threads")


def test_mistakes_are_told(plan, tmp_path):
    with pytest.raises(swayaw.FileError, match="plan.toml:1:"):
        plan.write_text("task = 1\n", encoding="utf-8")
        swayaw.sweep(plan, tmp_path / "out")
    recordings = tmp_path / "trials.toml"
    (tmp_path / "run.csv").write_text("time_s,psi_rad,delta_rad\n0,0,0\n", encoding="utf-8")
    recordings.write_text('task = "trial"\nruns = ["run.csv"]\n', encoding="utf-8")
    with pytest.raises(swayaw.Refusal, match="swayaw sweep"):
        swayaw.sweep(recordings, tmp_path / "out")
