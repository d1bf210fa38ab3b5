"""Problems of ship steering, each solved in two ways: by what users of Python have, and by swayaw."""

import dataclasses
import importlib.util
import math
import pathlib
from typing import Callable

import numpy

import swayaw

from . import force_regression, linear_zigzag, mmg_model, mmg_zigzag, state_filter

SHIP_FILE = pathlib.Path(__file__).parents[3] / "ships" / "kvlcc2.toml"
SHIP, NUMBERS = swayaw.read_ship(SHIP_FILE), mmg_model.read_mmg(SHIP_FILE)
TEN = math.radians(10)
NOISE = {"x_m": 0.5, "y_m": 0.5, "psi_rad": 1e-3, "u_m_s": 0.02, "v_m_s": 0.02, "r_rad_s": 5e-5}


@dataclasses.dataclass
class Problem:
    """Two ways to one result, and how far each is from the truth."""

    name: str
    peer: str
    by_peer: Callable
    call: str
    by_swayaw: Callable
    error: Callable  # of a result, a number in `unit`
    unit: str
    limit: float  # of both errors
    needs: str = "scipy"


def installed(module: str) -> bool:
    return importlib.util.find_spec(module) is not None


def compiled_model():
    return mmg_zigzag.compiled_model() if installed("numba") else None


def overshoots(zigzag) -> numpy.ndarray:
    return numpy.array([r.overshoot for r in zigzag.reversals])


def mmg_zigzags() -> list:
    """KVLCC2, 10/10. The truth is sailed by swayaw at 1e-12, and the peer at 1e-9 says how far that can be trusted."""

    def sail(tolerance, sampled=False):
        result = swayaw.zigzag(SHIP, TEN, TEN, tolerance=tolerance, sampled=sampled)
        return overshoots(result), result

    truth = sail(1e-12)[0]
    error = lambda result: numpy.degrees(abs(result[0] - truth).max())
    scipy = lambda **how: lambda: mmg_zigzag.by_scipy(NUMBERS, TEN, **how)
    loop = mmg_zigzag.compiled_loop() if installed("numba") else None
    loose, tight = dict(error=error, unit="deg", limit=1e-4), dict(error=error, unit="deg", limit=1e-7)
    name = "KVLCC2 zigzag 10/10, four overshoots"
    bare = dict(call="`zigzag(tolerance=1e-6, sampled=False)`", by_swayaw=lambda: sail(1e-6), **loose)
    return [
        Problem(name, "`solve_ivp`, RK45, rtol 1e-6", scipy(), **bare),
        Problem(
            "the same with its time series, 0.5 s",
            "`solve_ivp` with dense output",
            scipy(step=0.5),
            call="`zigzag(tolerance=1e-6)`",
            by_swayaw=lambda: sail(1e-6, sampled=True),
            **loose,
        ),
        Problem(
            "the same, indices to 1e-9",
            "`solve_ivp`, DOP853, rtol 1e-9",
            scipy(rtol=1e-9, method="DOP853"),
            call="`zigzag(sampled=False)`, its default",
            by_swayaw=lambda: sail(1e-9),
            **tight,
        ),
        Problem(name, "`solve_ivp`, equations compiled by numba", scipy(model=compiled_model()), needs="numba", **bare),
        Problem(name, "all compiled by numba, steps of 2 s", lambda: (loop(NUMBERS, TEN, 2.0),), needs="numba", **bare),
    ]


def linear_zigzags() -> list:
    """The chemical tanker of Artyszuk, 10/10; the truth is the same leg after leg in samples ten times closer."""
    ship = swayaw.load_ship("tanker97")
    c, rate = ship.coefficients, ship.steering_gear.rate * ship.length / ship.service_speed
    truth = linear_zigzag.zigzag(c, TEN, rate, spacing=0.02)
    error = lambda found: numpy.degrees(abs(found - truth).max())
    rest = dict(
        call="`linear_zigzag`",
        by_swayaw=lambda: overshoots(swayaw.linear_zigzag(c, TEN, TEN, rate)),
        error=error,
        unit="deg",
        limit=1e-4,
    )
    by = lambda simulator: lambda: linear_zigzag.zigzag(c, TEN, rate, simulator, spacing=0.2)
    name = "linear tanker, zigzag 10/10, six overshoots"
    return [
        Problem(name, "`scipy.signal.lsim`, 0.2 L", by(linear_zigzag.by_lsim), **rest),
        Problem(name, "`control.forced_response`, 0.2 L", by(linear_zigzag.by_control), needs="control", **rest),
    ]


def recorded(angle: int) -> tuple:
    """A zigzag of KVLCC2 at 2 Hz with noise of instruments, and without."""
    clean, run = (swayaw.zigzag(SHIP, math.radians(angle), math.radians(angle), step=0.5).run for _ in range(2))
    rng = numpy.random.default_rng(angle)
    for column, deviation in NOISE.items():
        run[column] += deviation * rng.standard_normal(len(run))
    run.name = f"zz{angle}"
    return run, clean


def regressions() -> list:
    """The 17 hull derivatives from three zigzags, judged by the hull's sway force and yaw moment in a fourth.

    swayaw begins with derivatives that are up to 20 % off; of the windows of the peer 31 samples are best, by the truth.
    """
    runs, other = [recorded(angle)[0] for angle in (10, 20, 30)], recorded(15)[1]
    names = [name for terms in force_regression.TERMS.values() for name in terms]
    given = {name: SHIP.parameters[name].value for name in names}
    rng = numpy.random.default_rng(1)
    begin = SHIP.with_values({name: value * (1.0 + 0.2 * rng.uniform(-1.0, 1.0)) for name, value in given.items()})
    U = numpy.hypot(other["u_m_s"], other["v_m_s"])
    v, r = other["v_m_s"] / U, other["r_rad_s"] * SHIP.length / U
    features = numpy.column_stack([v, r, v**3, v**2 * r, v * r**2, r**3])

    def error(found):
        """Root mean square over that of the force, the larger of sway and yaw [%]."""
        rms = lambda values, terms: numpy.sqrt(numpy.mean((features @ [values[name] for name in terms]) ** 2))
        off = {name: found[name] - given[name] for name in names}
        sway, yaw = (force_regression.TERMS[axis] for axis in "YN")
        return 100.0 * max(rms(off, terms) / rms(given, terms) for terms in (sway, yaw))

    def by_statsmodels(motion):
        found = force_regression.fit(runs, NUMBERS, lambda run: motion(run, window=31))
        return {name: value for name, (value, _) in found.items()}

    def by_swayaw(channels):
        fit = swayaw.fit_forces(begin, runs, names, channels=channels)
        return {name: c.estimate.value for name, c in fit.coefficients.items()}

    rest = dict(error=error, unit="% of force", limit=3.0, needs="statsmodels")
    return [
        Problem(
            f"17 hull derivatives from three zigzags, {sum(map(len, runs)):,} samples",
            "`savgol_filter`, `statsmodels` OLS, HAC errors",
            lambda: by_statsmodels(force_regression.from_velocities),
            "`fit_forces`, with its smoother",
            lambda: by_swayaw(["x", "y", "psi", "u", "v", "r"]),
            **rest,
        ),
        Problem(
            "the same from track and heading alone",
            "the same, differentiated twice",
            lambda: by_statsmodels(force_regression.from_track),
            "`fit_forces`",
            lambda: by_swayaw(["x", "y", "psi"]),
            **rest,
        ),
    ]


def filters() -> list:
    """States of a 20/20 zigzag, noise known, white accelerations, forward only; truth is the run without noise."""
    run, clean = recorded(20)
    process_noise = (2e-3, 2e-3, 1e-5)
    truth = numpy.column_stack([clean[column] for column in state_filter.CHANNELS])
    known = dict(zip(("x", "y", "psi", "u", "v", "r"), NOISE.values()))
    white = dict(process_noise=swayaw.PlanarAcceleration(*process_noise), coloured=False, smooth=False)

    def by_swayaw():
        return swayaw.estimate_states(SHIP, run, channels=list(known), noise=known, **white).states[:, :6]

    def error(states):
        """Error of the heading, root mean square."""
        return numpy.degrees(numpy.sqrt(numpy.mean((states - truth)[:, 2] ** 2)))

    by_numpy = lambda model: lambda: state_filter.filtered(run, NUMBERS, list(NOISE.values()), process_noise, model)
    rest = dict(call="`estimate_states(smooth=False)`", by_swayaw=by_swayaw, error=error, unit="deg rms", limit=0.03)
    name = f"extended Kalman filter, 6 states, {len(run):,} samples"
    return [
        Problem(name, "numpy, derivatives by differences", by_numpy(mmg_model.accelerations), **rest),
        Problem(name, "the same, equations compiled by numba", by_numpy(compiled_model()), needs="numba", **rest),
    ]


def all_problems() -> list:
    return mmg_zigzags() + linear_zigzags() + regressions() + filters()
