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


def _told(told, unit: str = "", scale: float = 1.0) -> str:
    """A number with its standard error."""
    if told is None:
        return "–"
    error = "" if math.isnan(told.standard_error) else f" ± {scale * told.standard_error:.2g}"
    return f"{scale * told.value:.4g}{error} {unit}".rstrip()


_degree = 180.0 / math.pi


def _zigzag_rows(trial):
    for i, r in enumerate(trial.reversals):
        yield f"overshoot {i + 1}, to {r.side}", _told(r.overshoot, "deg", _degree)
    yield "period", _told(trial.period, "s")


def _turn_rows(trial):
    for name in ("advance", "transfer", "tactical_diameter", "final_diameter"):
        yield name.replace("_", " "), _told(getattr(trial.corrected or trial.recorded, name), "m")
    yield "final yaw rate", _told(trial.final_yaw_rate, "deg/s", _degree)


def _trial(self) -> str:
    rows = []
    if self.zigzag:
        rows += _zigzag_rows(self.zigzag)
    if self.turn:
        rows += _turn_rows(self.turn)
    if self.steady:
        rows.append(("helm to port", _told(self.steady.helm, "deg", _degree)))
    nomoto = self.steering.least_squares
    if nomoto:
        rows += [("K, rudder to starboard", _told(nomoto.K, "1/s")), ("T", _told(nomoto.T, "s"))]
    rows += [
        (f"{c.name.replace('_', ' ')} to {c.side}, limit {number(c.limit)} {c.unit}",
         f"{_told(c.value, c.unit)}: {_verdict(c.passed)}")
        for c in self.imo
    ]
    notes = "".join(f"<p>{html.escape(note)}</p>" for note in self.notes)
    return table(f"{self.run}: {self.manoeuvre.name}", (), rows) + notes


def _percent(share: float) -> str:
    return f"{100.0 * share:.1f} %"


def _comparison(self) -> str:
    rows = [
        (e.quantity.replace("_", " "), _percent(e.normalised), _percent(e.open_loop_normalised),
         e.region.words if e.region else "–")
        for e in self.errors
    ]
    head = ("quantity", "over two lengths", "open loop", "most where")
    return table(f"{self.recorded.name}: error of its variation", head, rows)


def _check(self) -> str:
    rows = [(e.words,) for e in self.told] or [("no error of an instrument is told",)]
    return table(f"{self.run}: instruments by kinematics", (), rows)


def _found(effect) -> str:
    return ", ".join(f"{p.key} {p.value:.4g} ± {p.standard_error:.2g}" for p in effect.parameters)


def _diagnosis(self) -> str:
    parts = [f"<p><b>{html.escape(self.words)}</b></p>"]
    if self.effects:
        rows = [(e.effect.label, number(e.probability, digits=3), _found(e)) for e in self.effects]
        parts.append(table("Effects", ("effect", "probability", "numbers"), rows))
    if self.budget:
        causes = list(self.budget[0].shares)
        rows = [(cause.replace("_", " "), *(_percent(b.shares[cause]) for b in self.budget)) for cause in causes]
        head = ("follows", *(b.quantity.replace("_", " ") for b in self.budget))
        parts.append(table("The force that the model as given lacks", head, rows))
    for title, runs in (("Runs used", self.train), ("Runs held out", self.holdout)):
        rows = [
            (run.run, before.quantity.replace("_", " "), *(_percent(e.normalised) for e in (before, refitted, after)))
            for run in runs
            for before, refitted, after in zip(run.before, run.refitted, run.after)
        ]
        if rows:
            parts.append(table(title, ("run", "quantity", "as given", "refitted", "with effects"), rows))
    if self.next_manoeuvre:
        parts.append(f"<p>Next: {html.escape(self.next_manoeuvre.advice)}</p>")
    return "".join(parts)


def _trajectory_fit(self) -> str:
    rows = [
        (p.name, number(p.before), f"{p.estimate.value:.5g} ± {p.estimate.standard_error:.2g}", p.estimate.verdict)
        for p in self.parameters
    ]
    return table(f"{self.ship.name}: {self.status}", ("parameter", "before", "fitted, SI", ""), rows)


def _force_fit(self) -> str:
    rows = [
        (c.name, f"{c.estimate.value:.5g} ± {c.estimate.standard_error:.2g}", c.estimate.verdict)
        for c in self.coefficients.values()
    ]
    return table(self.ship.name, ("coefficient", "fitted", ""), rows) + f"<p>{html.escape(self.stability.words)}</p>"


def _tuning(self) -> str:
    numbers = [
        (p.name, number(p.before), number(p.after), _percent(p.prior), _percent(p.deviation), _percent(p.told))
        for p in self.parameters
    ]
    head = ("number", "before", "after", "deviation before", "after", "told by the indices")
    indices = [
        (i.measured.name, *(number(x / i.measured.si) for x in (i.measured.value, i.measured.deviation, i.before, i.after)))
        for i in self.indices
    ]
    return table(f"{self.ship.name}: {self.status}", head, numbers) + table(
        "Indices", ("index", "measured", "deviation", "before", "after"), indices
    )


def dress(module) -> None:
    module.Zigzag._repr_html_ = _zigzag
    module.TurningCircle._repr_html_ = _turning_circle
    module.ImoCriteria._repr_html_ = _criteria
    module.WilliamsonTurn._repr_html_ = _williamson_turn
    module.PullOut._repr_html_ = _pull_out
    module.TrialResult._repr_html_ = _trial
    module.RunCheck._repr_html_ = _check
    module.Comparison._repr_html_ = _comparison
    module.Diagnosis._repr_html_ = _diagnosis
    module.TrajectoryFit._repr_html_ = _trajectory_fit
    module.ForceFit._repr_html_ = _force_fit
    module.Tuning._repr_html_ = _tuning
