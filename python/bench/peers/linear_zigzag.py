"""A zigzag of a linear ship by scipy.signal.lsim, or by control.forced_response where python-control is installed."""

import numpy
from scipy import signal
from scipy.interpolate import CubicHermiteSpline


def matrices(c):
    """Of (beta, omega', psi) over ship lengths, from the six coefficients of the coupled equations."""
    A = numpy.array([[c.a1, c.b1, 0.0], [c.a2, c.b2, 0.0], [0.0, 1.0, 0.0]])
    return A, numpy.array([[c.c1], [c.c2], [0.0]]), numpy.eye(3), numpy.zeros((3, 1))


def by_lsim(A, B, C, D):
    """A function of times, rudder and start to states, exact at the samples where the rudder is straight between."""
    system = signal.StateSpace(A, B, C, D)
    return lambda s, delta, start: signal.lsim(system, delta, s, X0=start)[1]


def by_control(A, B, C, D):
    """The same by python-control."""
    import control

    system = control.ss(A, B, C, D)
    return lambda s, delta, start: control.forced_response(system, s, delta, start).states.T


def zigzag(c, angle, rate, simulator=by_lsim, reversals=6, spacing=0.1, longest=10.0):
    """Overshoots [rad], to starboard first; the rudder is positive to port, `rate` and `spacing` are by ship length.

    A leg is the way of the rudder and then `longest` ship lengths with the rudder held. Between samples states are
    cubic, with the slopes of the equations at both ends.
    """
    A, B, C, D = matrices(c)
    respond = simulator(A, B, C, D)
    start, delta, side = numpy.zeros(3), 0.0, 1.0
    overshoots = []
    for order in range(reversals + 1):
        ramp = numpy.linspace(0.0, abs(-side * angle - delta) / rate, 5)
        hold = spacing * numpy.arange(round(longest / spacing) + 1)
        moving = respond(ramp, numpy.interp(ramp, ramp[[0, -1]], [delta, -side * angle]), start)
        held = respond(hold, numpy.full(hold.size, -side * angle), moving[-1])
        s = numpy.concatenate([ramp, ramp[-1] + hold[1:]])
        states = numpy.concatenate([moving, held[1:]])
        rudder = numpy.interp(s, ramp[[0, -1]], [delta, -side * angle])
        slopes = states @ A.T + numpy.outer(rudder, B)
        psi = CubicHermiteSpline(s, states[:, 2], slopes[:, 2])
        peak = 0.0
        if order:
            peak = CubicHermiteSpline(s, states[:, 1], slopes[:, 1]).roots(extrapolate=False)[0]
            overshoots.append(abs(psi(peak)) - angle)
        reached = psi.solve(side * angle, extrapolate=False)
        reached = reached[reached > peak][0]
        start, delta = CubicHermiteSpline(s, states, slopes)(reached), numpy.interp(reached, s, rudder)
        side = -side
    return numpy.array(overshoots)
