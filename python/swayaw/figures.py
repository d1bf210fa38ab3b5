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


_beside = {"heading": "psi_deg", "yaw_rate": "r_deg_s", "speed": "u_m_s", "drift": "v_m_s"}


def comparison(result, axes=None):
    """Recorded and simulated, from the start and restarted every two ship lengths; the worst interval is shaded."""
    told = [e for e in result.errors if _beside.get(e.quantity, "") in result.recorded]
    if axes is None:
        axes = _axes(None, nrows=len(told), sharex=True, figsize=(8.0, 1.6 * len(told) + 0.6), squeeze=False)[:, 0]
    for error, axis in zip(told, axes):
        column = _beside[error.quantity]
        for run, how in (
            (result.recorded, dict(label="recorded", color="k")),
            (result.open_loop, dict(label="simulated")),
            (result.restarted, dict(label="restarted", linewidth=0.8)),
        ):
            if column in run:
                axis.plot(run.time, run[column], **how)
        if error.worst:
            axis.axvspan(error.worst.begin, error.worst.end, color="0.92", zorder=0)
        axis.set_ylabel(column)
    axes[0].legend(ncols=3, fontsize="small")
    axes[-1].set_xlabel("time, s")
    return axes


def trial(result, run, axes=None):
    """Heading and rudder of a recorded manoeuvre from its execute on, with the heading of the fitted K and T."""
    axes = _axes(axes)
    execute, rudder = result.approach.execute.value, "delta_deg" if "delta" in run else "delta_order_deg"
    axes.plot(run.time - execute, run["psi_deg"] - numpy.degrees(result.approach.heading.value), label="heading")
    axes.plot(run.time - execute, -run[rudder], label="rudder to starboard", linewidth=1)
    nomoto = result.steering.least_squares
    if nomoto is not None:
        axes.plot(nomoto.time - execute, numpy.degrees(nomoto.heading), ":", label="K and T")
    axes.set(xlabel="time from the execute, s", ylabel="deg off the approach")
    axes.legend()
    return axes


def missing_force(picture, axes=None):
    """Yaw moment that the refitted ship, and the ship with the effects, lack in a run; bands of two deviations."""
    axes = _axes(axes)
    for name, series in (("refitted", picture.missing_before), ("with effects", picture.missing_after)):
        if not series:
            continue
        moment = numpy.array([f.force.N for f in series])
        deviation = numpy.array([f.force_deviation.N for f in series])
        (line,) = axes.plot(picture.recorded.time, moment, label=name)
        axes.fill_between(
            picture.recorded.time, moment - 2 * deviation, moment + 2 * deviation, color=line.get_color(), alpha=0.2
        )
    axes.set(xlabel="time, s", ylabel="yaw moment that is missing, N m", title=picture.run)
    axes.legend()
    return axes


def budget(result, axes=None):
    """The force that the given ship lacks, by what it follows: shares with one standard error."""
    axes = _axes(axes)
    width = 0.8 / max(1, len(result.budget))
    for i, part in enumerate(result.budget):
        places = numpy.arange(len(part.shares)) + i * width
        axes.bar(
            places, 100.0 * numpy.array(part.share), width, yerr=100.0 * numpy.array(part.standard_error),
            label=part.quantity.replace("_", " "),
        )
    if result.budget:
        names = [name.replace("_", " ") for name in result.budget[0].shares]
        axes.set_xticks(numpy.arange(len(names)) + 0.4 - width / 2, names, rotation=20)
    axes.set_ylabel("% of its mean square")
    axes.legend()
    return axes


def diagnosis(result, axes=None):
    """Track and yaw rate of each run beside its replays by the ship as given and with the effects found; the runs must
    have been asked for: diagnose(…, pictures=True)."""
    pictures = result.train_pictures + result.holdout_pictures
    if not pictures:
        raise ValueError("there are no pictures of the runs; diagnose(…, pictures=True) keeps them")
    if axes is None:
        axes = _axes(None, nrows=len(pictures), ncols=2, figsize=(9.0, 3.2 * len(pictures)), squeeze=False)
    for picture, (left, right) in zip(pictures, axes):
        for run, how in (
            (picture.recorded, dict(label="recorded", color="k")),
            (picture.given, dict(label="as given", linestyle=":")),
            (picture.after, dict(label="with effects")),
        ):
            if run is None:
                continue
            if "x_m" in run and "y_m" in run:
                track(run, left, **how)
            if "r_rad_s" in run:
                right.plot(run.time, run["r_deg_s"], **how)
        left.set_title(picture.run)
        right.set(xlabel="time, s", ylabel="yaw rate, deg/s")
        right.legend(fontsize="small")
    return axes


def dress(module) -> None:
    module.Recording.plot = recording
    module.Zigzag.plot = zigzag
    module.TurningCircle.plot = turning_circle
    module.Spiral.plot = spiral
    module.Comparison.plot = comparison
    module.TrialResult.plot = trial
    module.RunPicture.plot = missing_force
    module.Diagnosis.plot = diagnosis
