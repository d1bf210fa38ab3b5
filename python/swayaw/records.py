"""What all value types of the extension have in common: repr, equality, `_asdict`, `_replace`."""

from __future__ import annotations

import math
from typing import Any

import numpy


def classes(module) -> list[type]:
    """The value types of the extension."""
    return [c for c in vars(module).values() if isinstance(c, type) and hasattr(c, "_fields")]


def _short(value: Any) -> str:
    if isinstance(value, numpy.ndarray):
        return f"array of {'×'.join(map(str, value.shape))}"
    if isinstance(value, list) and len(value) > 3:
        return f"[{len(value)} of {type(value[0]).__name__}]"
    if hasattr(type(value), "samples_in_words"):
        return value.samples_in_words()
    return repr(value)


def _repr(self) -> str:
    return f"{type(self).__name__}({', '.join(f'{name}={_short(getattr(self, name))}' for name in self._fields)})"


def same(a: Any, b: Any) -> bool:
    """Equality to the last bit; numbers that are missing are alike."""
    if isinstance(a, numpy.ndarray) or isinstance(b, numpy.ndarray):
        return numpy.array_equal(a, b, equal_nan=True)
    if isinstance(a, (list, tuple)) and isinstance(b, (list, tuple)):
        return len(a) == len(b) and all(same(x, y) for x, y in zip(a, b))
    if isinstance(a, dict) and isinstance(b, dict):
        return a.keys() == b.keys() and all(same(a[k], b[k]) for k in a)
    if isinstance(a, float) and isinstance(b, float) and math.isnan(a) and math.isnan(b):
        return True
    return a == b


def _eq(self, other) -> bool:
    if type(self) is not type(other):
        return NotImplemented
    return all(same(getattr(self, name), getattr(other, name)) for name in self._fields)


def _asdict(self) -> dict[str, Any]:
    """The fields by name; those within fields too."""

    def plain(value):
        if hasattr(type(value), "_fields"):
            return value._asdict()
        if isinstance(value, list):
            return [plain(x) for x in value]
        return value

    return {name: plain(getattr(self, name)) for name in self._fields}


def _replace(self, **values):
    """The same with other values of some fields."""
    fields = {name: getattr(self, name) for name in self._fields}
    unknown = values.keys() - fields.keys()
    if unknown:
        raise TypeError(f"{type(self).__name__} has no field {', '.join(sorted(unknown))}")
    result = type(self).__new__(type(self))
    result.__setstate__(tuple({**fields, **values}.values()))
    return result


def _recording_repr(self) -> str:
    return (
        f"<Recording {self.name!r}{', ' + self.manoeuvre if self.manoeuvre else ''}: {len(self)} samples, "
        f"{self.time[0]:g} to {self.time[-1]:g} s, {', '.join(self.columns)}>"
    )


def _recording_in_words(self) -> str:
    return f"<Recording of {len(self)} samples>"


def _same_state(self, other) -> bool:
    if type(self) is not type(other):
        return NotImplemented
    return same(self.__getstate__(), other.__getstate__())


def _ship_repr(self) -> str:
    effects = "".join(f" + {effect.id}" for effect in getattr(self, "effects", []))
    return f"<{type(self).__name__} {self.name!r}: {self.length:g} m, {self.service_speed:g} m/s{effects}>"


def dress(module) -> None:
    for c in classes(module):
        c.__repr__, c.__eq__, c._asdict, c._replace = _repr, _eq, _asdict, _replace
        c.__hash__ = None
    module.Recording.__repr__ = _recording_repr
    module.Recording.__eq__, module.Recording.__hash__ = _same_state, None
    module.Parameter.__eq__, module.Parameter.__hash__ = _same_state, None
    module.Recording.samples_in_words = _recording_in_words
    module.Ship.__repr__ = module.LinearShip.__repr__ = _ship_repr
