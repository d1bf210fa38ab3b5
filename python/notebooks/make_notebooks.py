"""The notebooks of this folder, run and rendered as pages of the documentation: docs/notebooks/NAME.md and its figures.

    PYTHONPATH=build/release/python /usr/bin/python3 python/notebooks/make_notebooks.py [NAME…] [--ipynb FOLDER]

A notebook is a Python file with cells: `# %%` begins one of code, `# %% [markdown]` one of text in comments. It runs as
a script, too. Needs the Debian packages python3-nbclient, jupyter-nbconvert and python3-ipykernel.
"""

from __future__ import annotations

import argparse
import os
import pathlib
import re
import sys
import tempfile
from typing import NamedTuple

here = pathlib.Path(__file__).resolve().parent
for variable in ("PYTHONPATH", "SWAYAW_RECORDINGS"):  # notebooks run in a folder of their own
    if os.environ.get(variable):
        os.environ[variable] = os.pathsep.join(map(os.path.abspath, os.environ[variable].split(os.pathsep)))
os.environ.setdefault("SWAYAW_SOURCE", str(here.parents[1]))
os.environ.setdefault("PYDEVD_DISABLE_FILE_VALIDATION", "1")  # words of the debugger of ipykernel
pages = here.parents[1] / "docs" / "notebooks"

# Runs before the notebook and is not shown: figures as SVG without a date and with text as text, tables as Markdown.
before = """
import matplotlib, pandas
%matplotlib inline
%config InlineBackend.figure_formats = ["svg"]
%config InlineBackend.print_figure_kwargs = {"metadata": {"Date": None}, "bbox_inches": "tight"}
matplotlib.rcParams.update({"svg.fonttype": "none", "svg.hashsalt": "swayaw", "path.simplify_threshold": 0.3})

def _table(frame):
    named = frame.index.name is not None or not isinstance(frame.index, pandas.RangeIndex)
    frame = frame.reset_index() if named else frame
    word = lambda x: str(x) if not isinstance(x, float) else f"{x:.0f}" if abs(x) >= 1e4 else f"{x:.4g}"
    rule = ["---:" if kind.kind in "fi" else "---" for kind in frame.dtypes]
    rows = [list(map(str, frame.columns)), rule, *(map(word, row) for row in frame.itertuples(index=False))]
    return "\\n".join("| " + " | ".join(row) + " |" for row in rows)

get_ipython().display_formatter.formatters["text/markdown"].for_type(pandas.DataFrame, _table)
get_ipython().display_formatter.formatters["text/html"].for_type(pandas.DataFrame, lambda frame: None)
"""


class Cell(NamedTuple):
    kind: str  # "code" or "markdown"
    text: str
    line: int  # of its first line in the file, from 1


def cells_of(text: str) -> list[Cell]:
    """The cells of a notebook file in their order."""
    found: list[tuple[str, int, list[str]]] = []
    for i, line in enumerate(text.splitlines(), 1):
        if line.startswith("# %%"):
            found.append(("markdown" if "[markdown]" in line else "code", i + 1, []))
        elif found:
            found[-1][2].append(line)
        elif line.strip():
            raise ValueError(f"{i}: a notebook begins with a line # %%")
    uncomment = lambda kind, line: re.sub(r"^# ?", "", line) if kind == "markdown" else line
    return [Cell(kind, "\n".join(uncomment(kind, x) for x in lines).strip("\n"), at) for kind, at, lines in found]


def notebook_of(cells: list[Cell]):
    """The same as a notebook of Jupyter."""
    from nbformat import v4

    made = [v4.new_code_cell(c.text) if c.kind == "code" else v4.new_markdown_cell(c.text) for c in cells]
    for i, cell in enumerate(made):
        cell.id = f"cell-{i}"
    kernel = {"name": "python3", "display_name": "Python 3", "language": "python"}
    return v4.new_notebook(cells=made, metadata={"kernelspec": kernel})


def run(cells: list[Cell], name: str):
    """The notebook with its outputs, run in an empty folder. Raises RuntimeError that tells file and line."""
    from nbclient import NotebookClient
    from nbclient.exceptions import CellExecutionError
    from nbformat import v4

    notebook = notebook_of(cells)
    notebook.cells.insert(0, v4.new_code_cell(before))
    with tempfile.TemporaryDirectory() as folder:
        client = NotebookClient(notebook, timeout=600, resources={"metadata": {"path": folder}})
        try:
            client.execute()
        except CellExecutionError as error:
            failed = [any(o.output_type == "error" for o in cell.get("outputs", ())) for cell in notebook.cells]
            wrong = failed.index(True)
            inside = re.findall(r"^-+> (\d+)", re.sub(r"\x1b\[[0-9;]*m", "", error.traceback), flags=re.M)
            line = cells[wrong - 1].line + (int(inside[0]) - 1 if inside else 0)
            text = cells[wrong - 1].text.splitlines()[line - cells[wrong - 1].line].strip()
            raise RuntimeError(f"{name}.py:{line}: {error.ename}: {error.evalue or text}") from None
    del notebook.cells[0]
    return notebook


def with_short_ids(svg: str) -> str:
    """The figure with p1, p2 … for its clip paths, whose names matplotlib makes anew in each run."""
    names: dict[str, str] = {}
    return re.sub(r"\bp[0-9a-f]{10}\b", lambda m: names.setdefault(m.group(), f"p{len(names) + 1}"), svg)


def render(notebook, name: str, folder: pathlib.Path) -> int:
    """Writes NAME.md and its figures NAME_1.svg …; how many bytes they have."""
    from nbconvert import MarkdownExporter

    exporter = MarkdownExporter()
    shown = ["text/markdown", "image/svg+xml", "image/png", "text/html", "text/plain"]
    for part in ("NbConvertBase", "ExtractOutputPreprocessor"):
        exporter.config[part].display_data_priority = shown
    exporter = MarkdownExporter(config=exporter.config)
    text, resources = exporter.from_notebook_node(notebook)
    for old in folder.glob(f"{name}_*.svg"):
        old.unlink()
    files = {}
    for i, (old, data) in enumerate(sorted(resources["outputs"].items(), key=lambda item: text.index(item[0])), 1):
        figure = pathlib.Path(old).suffix == ".svg"
        files[f"{name}_{i}{pathlib.Path(old).suffix}"] = with_short_ids(data.decode()).encode() if figure else data
        text = text.replace(old, f"{name}_{i}{pathlib.Path(old).suffix}")
    made = f"<!-- Made by python/notebooks/make_notebooks.py from python/notebooks/{name}.py. -->\n\n"
    text = "\n".join(line.rstrip() for line in text.splitlines()).strip() + "\n"
    parts = re.split(r"(^```python\n.*?^```$)", text, flags=re.M | re.S)  # what is between blocks of code, and those
    parts[::2] = [re.sub(r"\n{3,}", "\n\n", re.sub(r"!\[(svg|png)\]", "![figure]", part)) for part in parts[::2]]
    files[f"{name}.md"] = (made + "".join(parts)).encode()
    folder.mkdir(parents=True, exist_ok=True)
    for file, data in files.items():
        (folder / file).write_bytes(data)
    return sum(map(len, files.values()))


def names() -> list[str]:
    """Of all notebooks of this folder."""
    return sorted(f.stem for f in here.glob("*.py") if f.read_text(encoding="utf-8").startswith("# %%"))


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("names", nargs="*", metavar="NAME", help="of notebooks; all unless given")
    only = "only write notebooks of Jupyter there, not run"
    parser.add_argument("--ipynb", metavar="FOLDER", type=pathlib.Path, help=only)
    asked = parser.parse_args()
    for name in asked.names:
        if name not in names():
            parser.error(f"there is no notebook {name}; there are {', '.join(names())}")
    for name in asked.names or names():
        cells = cells_of((here / f"{name}.py").read_text(encoding="utf-8"))
        if asked.ipynb:
            import nbformat

            asked.ipynb.mkdir(parents=True, exist_ok=True)
            nbformat.write(notebook_of(cells), asked.ipynb / f"{name}.ipynb")
            continue
        try:
            print(f"{name}: {render(run(cells, name), name, pages) / 1000:.0f} kB", flush=True)
        except RuntimeError as error:
            print(error, file=sys.stderr)
            return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
