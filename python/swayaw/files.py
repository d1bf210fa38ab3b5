"""Files as the program takes them: recordings with their warnings, ships by file or by published name."""

from __future__ import annotations

import os
import pathlib
import warnings
from typing import Optional, Union

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
    """The same from text; `name` stands for the file in messages."""
    return _told(_swayaw._parse_csv(text, os.fspath(name), rudder_positive))


def load_ship(ship: Union[str, os.PathLike]) -> Union[_swayaw.Ship, _swayaw.LinearShip]:
    """A ship of any model from a ship file, or where no such file is there, the published ship of that bare name."""
    file = pathlib.Path(ship)
    if file.exists() or file.parent != pathlib.Path(".") or file.suffix:
        if not file.exists():
            _swayaw.read_ship(file)  # refuses it in words
        text = file.read_text(encoding="utf-8")
    else:
        text = _swayaw.published_text(str(ship))
    if _swayaw._model_of(text, file) == "linear":
        return _swayaw.parse_linear_ship(text, file)
    return _swayaw.parse_ship(text, file)
