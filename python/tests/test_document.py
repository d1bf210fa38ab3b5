"""The blocks of docs/python.md run one after the other, and so do the examples."""

import os
import pathlib
import re
import subprocess
import sys

import pytest


def test_the_document_runs(source, tmp_path, monkeypatch, capsys):
    text = (source / "docs" / "python.md").read_text(encoding="utf-8")
    blocks = re.findall(r"```python\n(.*?)```", text, flags=re.S)
    assert len(blocks) >= 5
    (tmp_path / "examples").symlink_to(source / "examples")
    monkeypatch.chdir(tmp_path)
    names = {}
    for block in blocks:
        exec(compile(block, "docs/python.md", "exec"), names)
    said = capsys.readouterr().out
    assert "[4.84, 12.84]" in said and "18 % less rudder force" in said


def run(source, name, *arguments) -> str:
    command = [sys.executable, source / "python" / "examples" / name, *arguments]
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout


def test_the_loop_of_artyszuk(source, tmp_path):
    said = run(source, "artyszuk_loop.py", tmp_path / "loop.png")
    assert "by T3b -0.2457" in said and (tmp_path / "loop.png").stat().st_size > 1000


def test_coefficients_of_kvlcc2(source):
    assert "after" in run(source, "kvlcc2_identification.py")


def test_the_esso_osaka_in_wind(source):
    folder = pathlib.Path(os.environ.get("SWAYAW_SHARED", "")) / "data" / "esso_osaka"
    files = sorted(folder.glob("turn_14-Sep-2020_15_47_33.csv"))
    if not files:
        pytest.skip("the recordings of the Esso Osaka are not there")
    assert "measured 2.03 m/s from 148 deg" in run(source, "esso_osaka_wind.py", *files)
