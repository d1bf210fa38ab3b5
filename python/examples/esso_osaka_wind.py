"""Whether a diagnosis finds the wind of the Esso Osaka model on the pond that it is not told: day by day beside the wind
that was measured on board, as in docs/results/esso_osaka_diagnosis.md.

The recordings (FRT-DS-ESSO, CC BY-NC 4.0) are not part of swayaw. The name of each ends with its day and time:

    python3 python/examples/esso_osaka_wind.py turn_14-Sep-2020_15_47_33.csv zigzag_31-Jul-2020_13_04_24.csv …
"""

import math
import pathlib
import re
import sys

import numpy

import swayaw

#: run, begin and end [s] of the part with way ahead
PARTS = pathlib.Path(__file__).parents[2] / "docs" / "results" / "esso_osaka_runs.txt"


def way_ahead(run: swayaw.Recording) -> swayaw.Recording:
    """The part of the run in which she makes way ahead; its group is the day."""
    frame = run.to_dataframe()
    for line in PARTS.read_text(encoding="utf-8").splitlines():
        name, begin, end = line.split()
        if name == pathlib.Path(run.name).stem:
            frame = frame[(frame.time_s >= float(begin)) & (frame.time_s <= float(end))]
    part = swayaw.Recording.from_dataframe(frame.reset_index(drop=True))
    day = re.search(r"\d+-\w+-\d+", run.name)
    part.remarks = {**part.remarks, "group": f'"{day[0] if day else run.name}"'}
    return part


def without_wind(run: swayaw.Recording) -> swayaw.Recording:
    """The same run, as if the wind had not been measured."""
    return swayaw.Recording.from_dataframe(run.to_dataframe().drop(columns=["wind_speed_m_s", "wind_from_rad"]))


def measured_wind(runs) -> tuple:
    """Speed [m/s] and direction [rad] of the steady wind with the same mean force: the mean of V² in both directions."""
    squares = [numpy.nanmean(run["wind_speed_m_s"] ** 2 * numpy.exp(1j * run["wind_from_rad"])) for run in runs]
    mean = sum(squares) / len(squares)
    return math.sqrt(abs(mean)), numpy.angle(mean) % (2.0 * math.pi)


def found_wind(part: swayaw.SurroundingsEstimate):
    """Speed, direction and the deviation of the direction of the wind in a part of the runs; None where none is told."""
    told = {p.key: p for p in part.parameters}
    if "wind_speed_m_s" not in told:
        return None
    direction = told["wind_from_rad"]
    return told["wind_speed_m_s"].value, direction.value % (2.0 * math.pi), direction.standard_error


runs = {part.name: part for part in (way_ahead(swayaw.read_csv(file)) for file in sys.argv[1:])}
ship = swayaw.published_ship("esso_osaka_3m")
result = swayaw.diagnose(ship, [without_wind(run) for run in runs.values()])
print(result.words)
for part in result.surroundings:
    speed, direction = measured_wind([runs[name] for name in part.runs])
    print(f"{part.scope}: measured {speed:.2f} m/s from {math.degrees(direction):.0f} deg", end=", ")
    found = found_wind(part)
    if found is None or part.cannot_tell:
        print(f"none found{': ' + part.cannot_tell if part.cannot_tell else ''}")
        continue
    off = math.remainder(found[1] - direction, 2.0 * math.pi)
    print(
        f"found {found[0]:.2f} m/s from {math.degrees(found[1]):.0f} ± {math.degrees(found[2]):.0f} deg: "
        f"{100.0 * (found[0] / speed - 1.0):+.0f} % and {math.degrees(off):+.0f} deg off"
    )
if not result.surroundings:
    speed, direction = measured_wind(runs.values())
    print(f"no wind found; measured {speed:.2f} m/s from {math.degrees(direction):.0f} deg")
