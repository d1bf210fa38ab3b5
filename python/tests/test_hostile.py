"""Files of others need not be trusted: docs/security.md."""

import html.parser
import re

import pytest

import swayaw

EVIL = '"><script>alert(1)</script><img src=x onerror=alert(1)>&\'`'


@pytest.fixture
def evil_run(source):
    """A recording whose name and manoeuvre are hostile."""
    text = (source / "examples/recordings/weak_rudder_zz10_10.csv").read_text(encoding="utf-8")
    manoeuvre = EVIL.replace("\\", "\\\\").replace('"', '\\"')
    text = re.sub(r"^# manoeuvre = .*$", lambda _: f'# manoeuvre = "{manoeuvre}"', text, flags=re.M)
    return swayaw.parse_csv(text, EVIL.replace("/", " ") + ".csv")


class Elements(html.parser.HTMLParser):
    def __init__(self, text):
        super().__init__()
        self.found, self.words = set(), ""
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        self.found.add(tag)
        assert not attributes

    def handle_data(self, words):
        self.words += words


def test_names_are_words_in_a_notebook(evil_run, model):
    shown = [swayaw.trial(evil_run, length=7.0), swayaw.check(evil_run), swayaw.compare(model, evil_run)]
    for result in shown:
        elements = Elements(result._repr_html_())
        assert elements.found <= {"table", "caption", "thead", "tbody", "tr", "th", "td", "p", "b"}
    assert any("<script>" in Elements(result._repr_html_()).words for result in shown)


def test_what_is_thrown_of_a_file_is_one_printable_line(tmp_path):
    for name in ("\x1b[31m.csv", "\u202e.toml", "a\nb.csv", "\x9b.csv"):
        with pytest.raises(swayaw.FileError) as error:
            swayaw.read_csv(tmp_path / name)
        assert str(error.value).isprintable()


def test_the_largest_file_that_is_read_can_be_told(source, tmp_path):
    ship, run = source / "ships/kvlcc2.toml", source / "examples/recordings/weak_rudder_turn35.csv"
    assert swayaw.largest_file() > swayaw.largest_file("description") > ship.stat().st_size
    swayaw.set_largest_file(1000)
    try:
        for read in (lambda: swayaw.read_csv(run), lambda: swayaw.load_ship(ship), lambda: swayaw.read_ship(ship)):
            with pytest.raises(swayaw.FileError, match="files of up to 1000 bytes are read here"):
                read()
    finally:
        swayaw.set_largest_file(0)
    swayaw.load_ship(ship)
    with pytest.raises(ValueError, match="use must be"):
        swayaw.largest_file("music")
