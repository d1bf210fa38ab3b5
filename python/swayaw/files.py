"""Files as the program takes them: recordings with their warnings, ships by file or by published name."""

from __future__ import annotations

import os
import pathlib
import warnings
from typing import Any, Mapping, Optional, Sequence, Union

from . import _swayaw


def _told(read) -> _swayaw.Recording:
    run, lines = read
    for line in lines:
        warnings.warn(line, stacklevel=3)
    return run


def read_csv(file: Union[str, os.PathLike], rudder_positive: Optional[str] = None) -> _swayaw.Recording:
    """A recording from a file of comma-separated text (docs/formats.md), as every command of the program reads it.

    All units become SI, the rudder positive to port, latitude and longitude a plane about the first fix, position and
    velocity those of midship. What the reader should be told is warned of.

    rudder_positive: "port" or "starboard", the side to which the rudder column is positive, whatever the file says.
    Raises FileError "FILE:LINE:COLUMN: what is wrong".
    """
    return _told(_swayaw._read_csv(os.fspath(file), rudder_positive))


def parse_csv(
    text: str, name: Union[str, os.PathLike] = "text", rudder_positive: Optional[str] = None
) -> _swayaw.Recording:
    """A recording from text as `read_csv` reads it.

    text: of a recording file. name: stands for the file in messages. rudder_positive: side to which the rudder column is
    positive, whatever the text says. Raises FileError "NAME:LINE:COLUMN: what is wrong".
    """
    return _told(_swayaw._parse_csv(text, os.fspath(name), rudder_positive))


def load_ship(ship: Union[str, os.PathLike]) -> Union[_swayaw.Ship, _swayaw.LinearShip]:
    """A ship of any model, nonlinear (Ship) or linear (LinearShip).

    ship: a ship file, or where no such file is there, the bare name of a published ship. Raises FileError
    "FILE:LINE:COLUMN: what is wrong", Refusal for a name that is not published.
    """
    file = pathlib.Path(ship)
    if file.exists() or file.parent != pathlib.Path(".") or file.suffix:
        text = _swayaw._ship_text(file)
    else:
        text = _swayaw.published_text(str(ship))
    if _swayaw._model_of(text, file) == "linear":
        return _swayaw.parse_linear_ship(text, file)
    return _swayaw.parse_ship(text, file)


def _toml(value: Any) -> str:
    """A value of an index file: a word, a number, a list, or a measured value with its deviation."""
    if isinstance(value, str):
        return f'"{value}"'
    if isinstance(value, Mapping):
        return "{ " + ", ".join(f"{key} = {_toml(x)}" for key, x in value.items()) + " }"
    if hasattr(value, "__len__"):
        return "[" + ", ".join(map(_toml, value)) + "]"
    return repr(float(value)) if value != int(value) else str(int(value))


def measured_indices(
    length: float,
    *,
    turns: Sequence[Mapping[str, Any]] = (),
    zigzags: Sequence[Mapping[str, Any]] = (),
    speed: Optional[float] = None,
    rev: Optional[float] = None,
    thrust: Optional[float] = None,
    tolerance: Optional[float] = None,
) -> _swayaw.MeasuredIndices:
    """Measured indices from dictionaries with the keys of an index file (docs/formats.md):

    measured_indices(56.85, speed=5.91, turns=[{"rudder_deg": 35, "advance_L": 2.2, "final_diameter_L": 1.2}],
                     zigzags=[{"rudder_deg": 10, "heading_deg": 20, "overshoot_deg": [15, 19]}])

    length: of the ship [m], for lengths in it. turns, zigzags: one dictionary for each manoeuvre; {"value": 2.2, "sd":
    0.1} tells a deviation. speed: of the approach [m/s]. rev: shaft speed [1/s], or thrust: of all propellers [N].
    tolerance: relative standard deviation of what has none, 0.05 unless given. Raises FileError "measured
    indices:LINE:COLUMN: what is wrong" with the line of the text that they make.
    """
    facts = {"speed_m_s": speed, "rev_s": rev, "thrust_N": thrust, "tolerance": tolerance}
    lines = [f"{key} = {_toml(value)}" for key, value in facts.items() if value is not None]
    for table, manoeuvres in (("turn", turns), ("zigzag", zigzags)):
        for manoeuvre in manoeuvres:
            lines += [f"[[{table}]]", *(f"{key} = {_toml(value)}" for key, value in manoeuvre.items())]
    return _swayaw.parse_indices("\n".join(lines) + "\n", length, "measured indices")
