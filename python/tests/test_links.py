"""Every link of the documents leads somewhere, and what docs/peers.md links to as an example runs."""

import pathlib
import re
import subprocess
import sys
import urllib.parse

import pytest

ROOT = pathlib.Path(__file__).parents[2]
DOCUMENTS = sorted([*ROOT.glob("*.md"), *ROOT.glob("*/README.md"), *(ROOT / "docs").rglob("*.md")])

LINK = re.compile(r"\]\(([^()\s]+)\)|^\[[^\]]+\]: (\S+)$", re.M)  # [words](target), [mark]: target


def prose(file: pathlib.Path) -> str:
    """A document without its code."""
    text = re.sub(r"^```.*?^```", "", file.read_text(encoding="utf-8"), flags=re.M | re.S)
    return re.sub(r"`[^`\n]*`", "``", text)


def links(file: pathlib.Path) -> list:
    return [a or b for a, b in LINK.findall(prose(file))]


def anchors(file: pathlib.Path) -> set:
    """Names of the headings as the pages of GitHub have them: lower case, blanks to hyphens, marks dropped."""
    found, count = set(), {}
    text = re.sub(r"^```.*?^```", "", file.read_text(encoding="utf-8"), flags=re.M | re.S)
    for heading in re.findall(r"^#+ +(.*?) *$", text, flags=re.M):
        words = re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", heading)
        name = re.sub(r"[^\w\- ]", "", words.lower()).replace(" ", "-")
        number = count[name] = count.get(name, -1) + 1
        found.add(f"{name}-{number}" if number else name)
    return found


@pytest.mark.parametrize("file", DOCUMENTS, ids=lambda file: str(file.relative_to(ROOT)))
def test_links_lead_somewhere(file):
    for link in links(file):
        if re.match(r"[a-z]+:", link):
            continue
        path, _, anchor = urllib.parse.unquote(link).partition("#")
        target = (file.parent / path).resolve() if path else file
        assert target.exists(), f"{file.relative_to(ROOT)}: {link}: no such file"
        if anchor and target.suffix == ".md":
            assert anchor in anchors(target), f"{file.relative_to(ROOT)}: {link}: no such heading"


def test_marks_of_links_are_defined():
    """[yes][vmm-1] needs a line [vmm-1]: address."""
    text = prose(ROOT / "docs" / "peers.md")
    used = set(re.findall(r"\]\[([\w-]+)\]", text))
    assert len(used) > 20 and used == set(re.findall(r"^\[([\w-]+)\]: https://", text, flags=re.M))


def test_the_tables_of_peers_are_made_from_their_file():
    command = [sys.executable, ROOT / "docs/peers/make_tables.py", "--check"]
    made = subprocess.run(command, capture_output=True, text=True)
    assert made.returncode == 0, made.stderr


EXAMPLES = sorted(link for link in links(ROOT / "docs/peers.md") if re.fullmatch(r"\.\./python/examples/\w+\.py", link))


@pytest.mark.parametrize("example", EXAMPLES)
def test_examples_of_peers_run(example, tmp_path):
    ran = subprocess.run([sys.executable, ROOT / "docs" / example], cwd=tmp_path, capture_output=True, text=True)
    assert ran.returncode == 0, ran.stderr
    assert len(ran.stdout.splitlines()) > 5


def test_a_second_way_finds_the_same_numbers(tmp_path):
    """Zigzags, filter and regression as one writes them with scipy, beside those of the module."""
    command = [sys.executable, ROOT / "python/bench/peers_speed.py", "--check"]
    ran = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True)
    assert ran.returncode == 0, ran.stderr
    assert "KVLCC2 zigzag 10/10" in ran.stdout
