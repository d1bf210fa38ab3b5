"""What T3b and T3w do to the drift-yaw loop of a zigzag, after Artyszuk 2016.

    python3 python/examples/artyszuk_loop.py [FIGURE.png]
"""

import math
import sys

import swayaw

ship = swayaw.load_ship("tanker97")
indices = ship.indices
zigzag = dict(rudder=math.radians(20), heading=math.radians(20))
rate = ship.steering_gear.rate * ship.length / ship.service_speed  # rad per ship length

exact = swayaw.loop_sensitivity(indices, **zigzag, rate=rate)
print(f"{ship.name}: T3b {indices.T3b:.3f}, T3w {indices.T3w:.3f}")
print(f"area of the loop {exact.value.area:.4f} rad, by T3b {exact.by_T3b.area:+.4f}, by T3w {exact.by_T3w.area:+.4f}")
overshoots = zip(exact.overshoot[:3], exact.overshoot_by_T3b, exact.overshoot_by_T3w)
for i, (angle, by_T3b, by_T3w) in enumerate(overshoots):
    print(f"overshoot {i + 1}: {math.degrees(angle):.2f} deg, by T3b {math.degrees(by_T3b):+.2f}, by T3w {math.degrees(by_T3w):+.2f}")

# the loop itself, for T3b as it is, half and none; the other indices stay
axes = None
for factor in (1.0, 0.5, 0.001):
    other = swayaw.coefficients_from(indices._replace(T3b=factor * indices.T3b))
    cycle = swayaw.limit_cycle(other, **zigzag, rate=rate)
    area = swayaw.drift_yaw_loop(other, cycle.zigzag).area
    print(f"T3b {factor * indices.T3b:.4f}: area {area:.4f} rad")
    if len(sys.argv) > 1:
        axes = swayaw.figures.drift_yaw_loop(other, cycle.zigzag, axes)
if axes is not None:
    axes.legend([f"T3b × {f:g}" for f in (1.0, 0.5, 0.001)])
    axes.figure.savefig(sys.argv[1])
