"""The notebooks run, each as a script in an empty folder, and their pages show the cells that they have now."""

import importlib.util
import os
import pathlib
import re
import subprocess
import sys

import pytest

root = pathlib.Path(os.environ.get("SWAYAW_SOURCE", pathlib.Path(__file__).parents[2]))
folder, pages = root / "python" / "notebooks", root / "docs" / "notebooks"
spec = importlib.util.spec_from_file_location("make_notebooks", folder / "make_notebooks.py")
make_notebooks = importlib.util.module_from_spec(spec)
spec.loader.exec_module(make_notebooks)

recordings = {"kvlcc2_identification": "kvlcc2", "esso_osaka_wind": "esso_osaka"}  # that are not part of swayaw


@pytest.mark.parametrize("name", make_notebooks.names())
def test_a_notebook_runs_and_finds_what_it_says(name, tmp_path):
    data = pathlib.Path(os.environ.get("SWAYAW_SHARED", "")) / "data"
    if name in recordings and not (data / recordings[name]).is_dir():
        pytest.skip(f"the recordings of {recordings[name]} are not there")
    settings = {"MPLBACKEND": "Agg", "SWAYAW_RECORDINGS": str(data), "SWAYAW_SOURCE": str(root)}
    done = subprocess.run(
        [sys.executable, folder / f"{name}.py"], cwd=tmp_path, env={**os.environ, **settings}, capture_output=True, text=True
    )
    assert done.returncode == 0, done.stderr


@pytest.mark.parametrize("name", sorted(recordings))
def test_a_notebook_without_its_recordings_says_so(name, tmp_path):
    settings = {"MPLBACKEND": "Agg", "SWAYAW_RECORDINGS": "nowhere"}
    done = subprocess.run(
        [sys.executable, folder / f"{name}.py"], cwd=tmp_path, env={**os.environ, **settings}, capture_output=True, text=True
    )
    assert done.returncode == 1 and re.fullmatch(r"nowhere/\w+: the recordings .* are not there; .*\n", done.stderr)


@pytest.mark.parametrize("name", make_notebooks.names())
def test_the_page_of_a_notebook_is_of_these_cells(name):
    page = (pages / f"{name}.md").read_text(encoding="utf-8")
    place = 0
    for cell in make_notebooks.cells_of((folder / f"{name}.py").read_text(encoding="utf-8")):
        shown = f"```python\n{cell.text}\n```" if cell.kind == "code" else cell.text
        place = page.find(shown, place)
        assert place >= 0, f"{name}.py:{cell.line}: not on its page; python/notebooks/make_notebooks.py {name} renders it"
    assert " at 0x" not in page  # an object that has no words
    for figure in re.findall(r"!\[figure\]\((.*?)\)", page):
        assert (pages / figure).stat().st_size > 1000


def test_every_notebook_has_a_page_in_the_list():
    text = (root / "docs" / "notebooks.md").read_text(encoding="utf-8")
    assert sorted(re.findall(r"\(notebooks/(\w+)\.md\)", text)) == make_notebooks.names()
    assert sum(file.stat().st_size for file in pages.iterdir()) < 2_000_000


def test_cells_keep_their_lines():
    text = "# %% [markdown]\n# # A title\n#\n# Text.\n\n# %%\nx = 1\n\n\n# %%\nx\n"
    cells = make_notebooks.cells_of(text)
    assert cells == [("markdown", "# A title\n\nText.", 2), ("code", "x = 1", 7), ("code", "x", 11)]
    with pytest.raises(ValueError, match="1: a notebook begins with a line # %%"):
        make_notebooks.cells_of("x = 1\n# %%\n")


def rendered(text, tmp_path):
    pytest.importorskip("nbclient")
    pytest.importorskip("nbconvert")
    pytest.importorskip("ipykernel")
    notebook = make_notebooks.run(make_notebooks.cells_of(text), "small")
    make_notebooks.render(notebook, "small", tmp_path)
    return (tmp_path / "small.md").read_text(encoding="utf-8")


def test_a_page_has_tables_and_figures(tmp_path):
    page = rendered(
        "# %% [markdown]\n# # Small\n\n# %%\nimport pandas, matplotlib.pyplot as plt\n"
        "pandas.DataFrame({'name': ['a'], 'value': [1.5]})\n\n# %%\nplt.plot([0, 1]);\n",
        tmp_path,
    )
    assert "# Small" in page and "| name | value |\n| --- | ---: |\n| a | 1.5 |" in page
    assert "![figure](small_1.svg)" in page
    assert "<dc:date>" not in (tmp_path / "small_1.svg").read_text()


def test_a_cell_that_fails_is_told_by_its_line(tmp_path):
    with pytest.raises(RuntimeError, match=r"^small\.py:4: AssertionError: assert x == 2$"):
        rendered("# %%\nx = 1\n\nassert x == 2\n", tmp_path)
