"""An extended Kalman filter of the six states of an MMG ship in numpy, as one writes it: Runge–Kutta steps,
derivatives by differences."""

import math

import numpy

from . import mmg_model

CHANNELS = ("x_m", "y_m", "psi_rad", "u_m_s", "v_m_s", "r_rad_s")


def filtered(run, p, noise, process_noise, model=mmg_model.accelerations):
    """States at the samples of a recording with all six channels, rudder and shaft speed.

    noise: standard deviations in the order of CHANNELS; process_noise: what the velocities gain in a second, (u, v, r).
    """
    n, rudder, measured = run["rev_s"], -run["delta_rad"], numpy.column_stack([run[c] for c in CHANNELS])
    scale = numpy.array([p.L, p.L, 1.0, p.U_0, p.U_0, p.U_0 / p.L])
    nudges = 1e-6 * numpy.diag(scale)
    R, I = numpy.diag(numpy.square(noise)), numpy.eye(6)
    x, P = measured[0].copy(), numpy.diag((0.25 * scale) ** 2)
    states = numpy.empty_like(measured)

    def slope(y, delta, rev):
        _, _, psi, u, v, r = y
        c, s = math.cos(psi), math.sin(psi)
        return numpy.array([u * c - v * s, u * s + v * c, r, *model(u, v, r, delta, rev, p)])

    def moved(y, h, begin, end, rev):
        k1 = slope(y, begin, rev)
        k2 = slope(y + 0.5 * h * k1, 0.5 * (begin + end), rev)
        k3 = slope(y + 0.5 * h * k2, 0.5 * (begin + end), rev)
        k4 = slope(y + h * k3, end, rev)
        return y + h / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4)

    for i, y in enumerate(measured):
        if i:
            h, delta = run.time[i] - run.time[i - 1], 0.5 * (rudder[i - 1] + rudder[i])
            base = slope(x, delta, n[i])
            A = numpy.column_stack([(slope(x + d, delta, n[i]) - base) / d.max() for d in nudges])
            F = I + h * A + 0.5 * h * h * A @ A
            x = moved(x, h, rudder[i - 1], rudder[i], n[i])
            Q = numpy.diag(numpy.concatenate([numpy.zeros(3), numpy.square(process_noise)]) * h)
            P = F @ (P + 0.5 * Q) @ F.T + 0.5 * Q
        K = numpy.linalg.solve(P + R, P).T
        e = y - x
        e[2] = math.remainder(e[2], 2.0 * math.pi)
        x = x + K @ e
        P = (I - K) @ P @ (I - K).T + K @ R @ K.T
        states[i] = x
    return states
