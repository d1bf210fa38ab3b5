"""Ship steering dynamics: standard manoeuvres of a ship from a file, recorded ones judged, and why the two differ.

Axes: x forward, y to starboard, z down, origin midship. Heading and yaw rate are positive to starboard, rudder angles
positive to port. SI and radians throughout; another unit shows in the name. docs/python.md is the place to start.
"""

from . import _swayaw
from ._swayaw import *  # noqa: F401,F403
from ._swayaw import __version__
from .files import load_ship, measured_indices, parse_csv, read_csv
from .state_space import StateSpace
from .tables import Channel, channels, frame_of
from . import figures, html, records, state_space, tables

if hasattr(_swayaw, "SweepWork"):  # of a build with the program
    from .sweeps import sweep  # noqa: F401

records.dress(_swayaw)
tables.dress(_swayaw)
state_space.dress(_swayaw)
figures.dress(_swayaw)
html.dress(_swayaw)

__all__ = sorted(
    [name for name in vars(_swayaw) if not name.startswith("_")]
    + ["Channel", "StateSpace", "channels", "figures", "frame_of", "load_ship", "measured_indices", "parse_csv"]
    + ["read_csv", "__version__"] + (["sweep"] if hasattr(_swayaw, "SweepWork") else [])
)
