"""A zigzag of an MMG ship, to starboard first and to the fourth overshoot: by scipy.integrate.solve_ivp, and by a loop
of one's own that numba compiles."""

import math

import numpy
from scipy.integrate import solve_ivp

from . import mmg_model

ORDERS = 5  # the first, and one at each of four reversals


def by_scipy(p, angle, model=mmg_model.accelerations, rtol=1e-6, step=None, method="RK45"):
    """Overshoots [rad], and where a step is asked for, times and states at its multiples.

    One call of solve_ivp for each piece between kinks of the rudder, so that no step runs over one; heading and peak
    are events that end a piece.
    """
    n = mmg_model.self_propulsion(p, model)
    state = numpy.array([0.0, 0.0, 0.0, p.U_0, 0.0, 0.0])
    time = delta = rate = 0.0
    overshoots, times, states = [], [], []

    def rhs(t, y):
        _, _, psi, u, v, r = y
        c, s = math.cos(psi), math.sin(psi)
        return (u * c - v * s, u * s + v * c, r, *model(u, v, r, delta + rate * (t - time), n, p))

    def reached(t, y):
        return y[2] - side * angle

    def peak(t, y):
        return y[5]

    reached.terminal = peak.terminal = True

    def sail(until, event=None):
        """Sails on; true if the event ended it."""
        nonlocal state, time, delta
        way = solve_ivp(
            rhs, (time, until), state, method, rtol=rtol, atol=1e-3 * rtol, events=event, dense_output=step is not None
        )
        if step is not None:
            times.append(step * numpy.arange(math.ceil(time / step), math.ceil(way.t[-1] / step)))
            states.append(way.sol(times[-1]))
        time, state, delta = way.t[-1], way.y[:, -1], delta + rate * (way.t[-1] - time)
        return way.status == 1

    for order in range(ORDERS):
        side = -1.0 if order % 2 else 1.0
        rate = math.copysign(p.rate, side * angle - delta)
        hard_over = time + (side * angle - delta) / rate
        peaked = order == 0
        if not peaked and sail(hard_over, peak):
            overshoots.append(abs(state[2]) - angle)
            peaked = True
        if time < hard_over:
            sail(hard_over)
        rate, delta = 0.0, side * angle
        if not peaked:
            sail(math.inf, peak)
            overshoots.append(abs(state[2]) - angle)
        if order + 1 < ORDERS:
            sail(math.inf, reached)
    return numpy.array(overshoots), (numpy.concatenate(times), numpy.hstack(states)) if step is not None else None


def compiled_model():
    """The equations compiled by numba, for by_scipy."""
    import numba

    return numba.njit(mmg_model.accelerations)


def compiled_loop():
    """A function of ship, angle and step: overshoots by Runge–Kutta steps of fourth order in one compiled loop. A step
    that runs over a kink of the rudder, the heading or the peak is made again to end there."""
    import numba

    accelerations = numba.njit(mmg_model.accelerations)

    @numba.njit
    def slope(y, delta, n, p):
        _, _, psi, u, v, r = y
        c, s = math.cos(psi), math.sin(psi)
        du, dv, dr = accelerations(u, v, r, delta, n, p)
        return (u * c - v * s, u * s + v * c, r, du, dv, dr)

    @numba.njit
    def ahead(y, k, h):
        return (y[0] + h * k[0], y[1] + h * k[1], y[2] + h * k[2], y[3] + h * k[3], y[4] + h * k[4], y[5] + h * k[5])

    @numba.njit
    def stepped(y, delta, rate, h, n, p):
        k1 = slope(y, delta, n, p)
        k2 = slope(ahead(y, k1, 0.5 * h), delta + 0.5 * h * rate, n, p)
        k3 = slope(ahead(y, k2, 0.5 * h), delta + 0.5 * h * rate, n, p)
        k4 = slope(ahead(y, k3, h), delta + h * rate, n, p)
        y = ahead(ahead(y, k1, h / 6.0), k2, h / 3.0)
        return ahead(ahead(y, k3, h / 3.0), k4, h / 6.0)

    @numba.njit
    def zigzag(p, n, angle, step):
        y = (0.0, 0.0, 0.0, p.U_0, 0.0, 0.0)
        delta, side, order, peaked = 0.0, 1.0, 0, True
        overshoots = numpy.empty(ORDERS - 1)
        while True:
            left = side * angle - delta
            rate = math.copysign(p.rate, left) if left != 0.0 else 0.0
            h = min(step, left / rate) if left != 0.0 else step
            i, level = (2, side * angle) if peaked else (5, 0.0)  # of the state that ends this phase
            begin = y[i] - level
            z = stepped(y, delta, rate, h, n, p)
            event = begin != 0.0 and begin * (z[i] - level) <= 0.0
            if event:  # regula falsi (Illinois) on the length of the step
                low, high, f_low, f_high = 0.0, h, begin, z[i] - level
                for _ in range(60):
                    h = high - f_high * (high - low) / (f_high - f_low)
                    z = stepped(y, delta, rate, h, n, p)
                    f = z[i] - level
                    if abs(f) < 1e-13:
                        break
                    if f * f_high < 0.0:
                        low, f_low = high, f_high
                    else:
                        f_low *= 0.5
                    high, f_high = h, f
            delta = side * angle if h * rate == left else delta + h * rate
            y = z
            if event and not peaked:
                overshoots[order - 1] = abs(y[2]) - angle
                if order == ORDERS - 1:
                    return overshoots
                peaked = True
            elif event:
                order, side, peaked = order + 1, -side, False

    return lambda p, angle, step: zigzag(p, mmg_model.self_propulsion(p, accelerations), angle, step)
