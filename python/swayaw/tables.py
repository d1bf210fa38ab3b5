"""Recordings and results as tables of pandas."""

from __future__ import annotations

from typing import Any, Mapping, NamedTuple, Optional

import numpy

from . import _swayaw


class Channel(NamedTuple):
    """What a recording can hold."""

    name: str  #: without its unit, "psi"
    column: str  #: in SI, "psi_rad"
    units: dict[str, float]  #: all columns that are understood, with the SI value of one unit
    shows_motion: bool  #: of the ship, and not what drives her or the weather


def channels() -> list[Channel]:
    """All channels of recordings, in their order."""
    return [Channel(*row) for row in _swayaw._channels()]


def _pandas():
    try:
        import pandas
    except ImportError as e:
        raise ImportError("tables need pandas (Debian package python3-pandas)") from e
    return pandas


def _number(cells: list[str]):
    """Cells of a column that is not understood, as numbers where all of them are."""
    try:
        return numpy.array([float(cell) if cell.strip() else numpy.nan for cell in cells])
    except ValueError:
        return cells


def to_dataframe(self: _swayaw.Recording, copy: bool = True):
    """The recording as a pandas.DataFrame: time_s, the SI columns that were recorded, and columns that swayaw does not
    understand. `attrs` holds name, manoeuvre, execute_s, water_depth_m and the other run keys.

    copy=False: the columns are the samples themselves, without a copy; writing to them changes the recording.
    """
    columns: dict[str, Any] = {"time_s": self.time}
    columns.update({name: self[name] for name in self.columns})
    columns.update({name: _number(cells) for name, cells in self.extra.items()})
    frame = _pandas().DataFrame(columns, copy=copy)
    facts = {"name": self.name, "manoeuvre": self.manoeuvre, "execute_s": self.execute, "water_depth_m": self.water_depth}
    frame.attrs.update({key: value for key, value in facts.items() if value not in (None, "")})
    frame.attrs.update(self.remarks)
    return frame


#: Columns that only the reader of files turns into channels.
_projected = ("lat_deg", "lon_deg")


def _header_value(value: Any) -> str:
    if isinstance(value, bool):
        return "true" if value else "false"
    return repr(float(value)) if isinstance(value, (int, float)) else '"' + str(value).replace('"', '\\"') + '"'


def _through_text(frame, name: str, rudder_positive: str, facts: Mapping[str, Any]) -> _swayaw.Recording:
    """By the text of a file: where positions are latitude and longitude, or are not of midship."""
    from .files import parse_csv

    header = "".join(f"# {key} = {_header_value(value)}\n" for key, value in facts.items() if value is not None)
    text = f'# rudder_positive = "{rudder_positive}"\n{header}{frame.to_csv(index=False)}'
    return parse_csv(text, name or "frame")


def from_dataframe(
    frame,
    *,
    time: Optional[str] = None,
    name: Optional[str] = None,
    rudder_positive: str = "port",
    manoeuvre: Optional[str] = None,
    execute: Optional[float] = None,
    water_depth: Optional[float] = None,
    reference_x: float = 0.0,
) -> _swayaw.Recording:
    """A recording from a pandas.DataFrame whose columns are named as in recording files: psi_deg, r_rad_s, delta_deg …

    Each column is copied once, into SI. Time is the column `time`, else time_s, else the index: seconds, or dates, which
    count from the first. Columns that are not understood are kept as text. What is not given is taken from `frame.attrs`
    as `to_dataframe` leaves it there.

    rudder_positive: side to which rudder angles of the frame are positive. execute: time of the first rudder order [s].
    water_depth [m]. reference_x: point of which positions and velocities are, forward of midship [m]. With it, and with
    latitude and longitude, the frame goes through the text of a file and is copied more often.
    """
    pandas = _pandas()
    facts = frame.attrs
    name = facts.get("name", "") if name is None else name
    manoeuvre = facts.get("manoeuvre", "") if manoeuvre is None else manoeuvre
    execute = facts.get("execute_s") if execute is None else execute
    water_depth = facts.get("water_depth_m") if water_depth is None else water_depth
    remarks = {k: v for k, v in facts.items() if k not in ("name", "manoeuvre", "execute_s", "water_depth_m")}
    if remarks.pop("order_recorded", False) in (True, "true"):
        frame = frame.rename(columns={"delta_rad": "delta_order_rad", "delta_deg": "delta_order_deg"})
    if "ordered_rev_s" in remarks and not {"rev_s", "rev_rpm"} & set(frame.columns):
        frame = frame.assign(rev_s=float(remarks.pop("ordered_rev_s")))
    key = time or ("time_s" if "time_s" in frame.columns else None)
    if reference_x or any(column in frame.columns for column in _projected):
        if key != "time_s":
            raise ValueError("positions of another point, and latitude and longitude, need the time in time_s")
        given = {"manoeuvre": manoeuvre or None, "execute_s": execute, "water_depth_m": water_depth}
        run = _through_text(frame, name, rudder_positive, {**given, "reference_x_m": reference_x or None})
        run.remarks = {**run.remarks, **remarks}
        return run
    times = frame[key] if key else frame.index
    if isinstance(times.dtype, pandas.DatetimeTZDtype) or times.dtype.kind == "M":
        times = (times - times[0]) / pandas.Timedelta(seconds=1)
    known = {column for channel in channels() for column in channel.units}
    understood = {c: frame[c].to_numpy(copy=False) for c in frame.columns if c in known}
    run = _swayaw.Recording(
        numpy.asarray(times, dtype=float),
        understood,
        name=name,
        rudder_positive=rudder_positive,
        manoeuvre=manoeuvre,
        execute=execute,
        water_depth=water_depth,
    )
    others = [c for c in frame.columns if c not in known and c != key]
    run.extra = {str(c): ["" if pandas.isna(x) else str(x) for x in frame[c]] for c in others}
    run.remarks = remarks
    return run


def frame_of(records):
    """Values of one type, such as `diagnosis.candidates` or `zigzag.reversals`, as a pandas.DataFrame: a row for each, a
    column for each field.

    records: a list of values of one type.
    """
    return _pandas().DataFrame([record._asdict() for record in records])


def criteria_table(self):
    """The criteria as a pandas.DataFrame: criterion, first to, value, limit, unit, passed."""
    rows = [(c.name, c.side, c.value, c.limit, c.unit, c.passed) for c in self.criteria]
    return _pandas().DataFrame(rows, columns=["criterion", "first_to", "value", "limit", "unit", "passed"])


def parameter_table(self):
    """The parameters of a ship as a pandas.DataFrame by name: table, value, unit, low, high, deviation, role."""
    rows = {
        name: (p.table, p.value, p.unit, *p.range, p.deviation, p.role) for name, p in self.parameters.items()
    }
    columns = ["table", "value", "unit", "low", "high", "deviation", "role"]
    return _pandas().DataFrame.from_dict(rows, orient="index", columns=columns)


def dress(module) -> None:
    module.Recording.to_dataframe = to_dataframe
    module.Recording.from_dataframe = staticmethod(from_dataframe)
    module.ImoCriteria.to_dataframe = criteria_table
    module.Ship.parameter_table = parameter_table
