"""Results as tables in notebooks."""

from __future__ import annotations

import html
import math
from typing import Any, Optional, Sequence


def table(caption: str, head: Sequence[str], rows: Sequence[Sequence[Any]]) -> str:
    """A table of HTML."""

    def cells(tag: str, row: Sequence[Any]) -> str:
        return "".join(f"<{tag}>{html.escape(str(cell))}</{tag}>" for cell in row)

    body = "".join(f"<tr>{cells('td', row)}</tr>" for row in rows)
    top = f"<thead><tr>{cells('th', head)}</tr></thead>" if head else ""
    return f"<table><caption>{html.escape(caption)}</caption>{top}<tbody>{body}</tbody></table>"


def number(value: Optional[float], unit: str = "", digits: int = 4) -> str:
    """A number as people read it; a dash for none."""
    if value is None or (isinstance(value, float) and math.isnan(value)):
        return "–"
    return f"{value:.{digits}g}{' ' + unit if unit else ''}"


def degrees(value: Optional[float]) -> str:
    return number(None if value is None else math.degrees(value), "deg")


def _zigzag(self) -> str:
    rows = [
        (i + 1, number(r.time, "s"), number(r.peak_time, "s"), degrees(r.overshoot))
        for i, r in enumerate(self.reversals)
    ]
    caption = f"{self.run.manoeuvre or 'Zigzag'} at {number(self.approach_speed, 'm/s')}, period {number(self.period, 's')}"
    return table(caption, ("reversal", "time", "peak", "overshoot"), rows)


def _turning_circle(self) -> str:
    rows = [
        ("advance", number(self.advance, "m")),
        ("transfer", number(self.transfer, "m")),
        ("tactical diameter", number(self.tactical_diameter, "m")),
        ("final diameter", number(self.final_diameter, "m")),
        ("time to 90 deg", number(self.time_90, "s")),
        ("time to 180 deg", number(self.time_180, "s")),
    ]
    return table(f"{self.run.manoeuvre or 'Turning circle'} at {number(self.approach_speed, 'm/s')}", (), rows)


def _verdict(passed: Optional[bool]) -> str:
    return "not judged" if passed is None else "pass" if passed else "fail"


def _criteria(self) -> str:
    rows = [
        (c.name.replace("_", " "), c.side, number(c.value), f"{number(c.limit)} {c.unit}", _verdict(c.passed))
        for c in self.criteria
    ]
    return table("Steering criteria of MSC.137(76)", ("criterion", "first to", "value", "limit", "verdict"), rows)


def _williamson_turn(self) -> str:
    places = [("rudder shifted", self.shifted), ("amidships", self.amidships), ("reciprocal heading", self.reciprocal)]
    rows = [(what, number(p.time, "s"), number(p.along, "m"), number(p.offset, "m")) for what, p in places if p]
    return table("Williamson turn", ("", "time", "along the track", "beside it"), rows)


def _pull_out(self) -> str:
    sides = [("port", self.sides.port), ("starboard", self.sides.starboard)]
    rows = [
        (name, number(s.turning, "rad/s"), number(s.residual, "rad/s"), number(s.fall_time, "s")) for name, s in sides
    ]
    return table("Pull-out", ("from a turn to", "yaw rate", "left of it", "falls to 1/e in"), rows)


def dress(module) -> None:
    module.Zigzag._repr_html_ = _zigzag
    module.TurningCircle._repr_html_ = _turning_circle
    module.ImoCriteria._repr_html_ = _criteria
    module.WilliamsonTurn._repr_html_ = _williamson_turn
    module.PullOut._repr_html_ = _pull_out
