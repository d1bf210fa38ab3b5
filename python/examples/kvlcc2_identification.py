"""Coefficients of KVLCC2 in the PI form from zigzags, judged by runs that were not used.

    python3 python/examples/kvlcc2_identification.py              # zigzags that are simulated here, with noise
    python3 python/examples/kvlcc2_identification.py USED.csv… --holdout OTHER.csv…
"""

import math
import sys

import numpy

import swayaw


def simulated(name: str, angle: float) -> swayaw.Recording:
    """A zigzag of the MMG ship with noise of instruments."""
    run = swayaw.zigzag(swayaw.published_ship("kvlcc2_l7"), math.radians(angle), math.radians(angle), step=0.2).run
    rng = numpy.random.default_rng(int(angle))
    for column, deviation in {"x_m": 0.02, "y_m": 0.02, "psi_rad": 1e-3, "r_rad_s": 3e-4, "u_m_s": 3e-3, "v_m_s": 3e-3}.items():
        run[column] += deviation * rng.standard_normal(len(run))
    run.name = name
    return run


files = sys.argv[1:]
if files:
    cut = files.index("--holdout")
    used, held = ([swayaw.read_csv(f) for f in part] for part in (files[:cut], files[cut + 1 :]))
else:
    used, held = [simulated("zz20", 20), simulated("zz10", 10)], [simulated("zz15", 15)]

ship = swayaw.published_ship("kvlcc2_pi")
fit = swayaw.fit_forces(ship, used)
for c in fit.coefficients.values():
    print(f"{c.name:8} {c.estimate.value:10.5f} ± {c.estimate.standard_error:.5f}  {c.estimate.verdict}")
print(fit.stability.words)
for run in held:
    before, after = (swayaw.compare(s, run)["yaw_rate"].normalised for s in (ship, fit.ship))
    print(f"{run.name}: error of the yaw rate {100 * before:.1f} % of its variation before, {100 * after:.1f} % after")
