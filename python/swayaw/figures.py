"""Figures of recordings and manoeuvres by matplotlib. Angles in degrees, axes equal where they are places."""

from __future__ import annotations

import numpy


def _axes(axes, **how):
    if axes is not None:
        return axes
    import matplotlib.pyplot as plt

    return plt.subplots(layout="constrained", **how)[1]


def track(run, axes=None, **line):
    """The track of a recording, north up."""
    axes = _axes(axes)
    axes.plot(run["y_m"], run["x_m"], **line)
    axes.set(xlabel="east, m", ylabel="north, m", aspect="equal")
    return axes


def heading_and_rudder(run, axes=None, **line):
    """Heading and rudder over time, both positive to starboard."""
    axes = _axes(axes)
    axes.plot(run.time, run["psi_deg"], label="heading", **line)
    rudder = "delta_deg" if "delta" in run else "delta_order_deg"
    axes.plot(run.time, -run[rudder], label="rudder to starboard", **{**line, "linewidth": 1})
    axes.set(xlabel="time, s", ylabel="deg")
    axes.axhline(0.0, color="0.8", linewidth=0.5, zorder=0)
    axes.legend()
    return axes


def recording(run, axes=None):
    """Every channel of a recording over time, one below the other."""
    from .tables import channels

    shown = [c for c in channels() if c.column in run]
    if axes is None:
        axes = _axes(None, nrows=len(shown), sharex=True, figsize=(8.0, 1.1 * len(shown) + 0.6), squeeze=False)[:, 0]
    for channel, axis in zip(shown, axes):
        column = next((c for c in channel.units if c.endswith("_deg")), channel.column)
        axis.plot(run.time, run[column], linewidth=1)
        axis.set_ylabel(column, rotation=0, ha="right", va="center")
    axes[-1].set_xlabel("time, s")
    return axes


def zigzag(result, axes=None):
    """Heading and rudder of a zigzag; the peaks are marked."""
    axes = heading_and_rudder(result.run, axes)
    peaks = [r.peak_time for r in result.reversals if r.peak_time is not None]
    axes.plot(peaks, numpy.interp(peaks, result.run.time, result.run["psi_deg"]), "k.", label="peak")
    return axes


def turning_circle(result, axes=None):
    """The track of a turning circle with advance and tactical diameter."""
    axes = track(result.run, axes)
    side = numpy.sign(result.run["psi_rad"][-1])
    if result.advance is not None:
        axes.axhline(result.advance, color="0.6", linewidth=0.8)
        axes.annotate(f"advance {result.advance:.0f} m", (0.0, result.advance), va="bottom", fontsize="small")
    if result.tactical_diameter is not None:
        axes.axvline(side * result.tactical_diameter, color="0.6", linewidth=0.8)
        axes.annotate(
            f"tactical diameter {result.tactical_diameter:.0f} m", (side * result.tactical_diameter, 0.0), rotation=90,
            ha="right", fontsize="small",
        )
    return axes


def spiral(result, axes=None):
    """Yaw rate over rudder angle: as sailed down and up, and the curve of all steady turns."""
    axes = _axes(axes)
    for name, points in (("down", result.down), ("up", result.up)):
        axes.plot(
            numpy.degrees([-p.delta for p in points]), numpy.degrees([p.motion.r for p in points]), ".-", label=name
        )
    for stable, style in ((True, "k-"), (False, "k:")):
        r = [numpy.degrees(p.motion.r) if p.stable == stable else numpy.nan for p in result.curve]
        axes.plot(numpy.degrees([-p.delta for p in result.curve]), r, style, linewidth=0.6)
    axes.set(xlabel="rudder to starboard, deg", ylabel="yaw rate, deg/s")
    axes.legend()
    return axes


def drift_yaw_loop(coefficients, result, axes=None, samples=800):
    """The last full cycle of a linear zigzag in the plane of drift and yaw rate."""
    axes = _axes(axes)
    begin, end = result.reversals[-3].execute, result.reversals[-1].execute
    states = result.states(coefficients, numpy.linspace(begin, end, samples))
    axes.plot(numpy.degrees(states["beta"]), states["omega"])
    axes.set(xlabel="drift angle, deg", ylabel="rL/U")
    return axes


def dress(module) -> None:
    module.Recording.plot = recording
    module.Zigzag.plot = zigzag
    module.TurningCircle.plot = turning_circle
    module.Spiral.plot = spiral
