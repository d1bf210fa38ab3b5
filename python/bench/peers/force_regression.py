"""Hull derivatives of an MMG ship by least squares on forces of inverse dynamics, with scipy.signal and statsmodels."""

import numpy
from scipy.signal import savgol_filter

TERMS = {
    "X": ("R_0", "X_vv", "X_vr", "X_rr", "X_vvvv"),
    "Y": ("Y_v", "Y_r", "Y_vvv", "Y_vvr", "Y_vrr", "Y_rrr"),
    "N": ("N_v", "N_r", "N_vvv", "N_vvr", "N_vrr", "N_rrr"),
}


def propeller_and_rudder(u, v, r, delta, n, p):
    """Forces (X, Y, N) of arrays; the rudder angle is positive to starboard. Equations as in mmg_model.py."""
    U = numpy.hypot(u, v)
    beta, r_ = numpy.arctan2(-v, u), r * p.L / U
    beta_P, beta_R = beta - p.x_P * r_, beta - p.l_R * r_
    C_2 = numpy.where(beta_P > 0.0, p.C_2_positive, p.C_2_negative)
    u_P = u * (1.0 - p.w_P0) * (1.0 + (1.0 - numpy.exp(-p.C_1 * abs(beta_P))) * (C_2 - 1.0))
    J = u_P / (n * p.D)
    K_T = p.k_0 + p.k_1 * J + p.k_2 * J**2
    v_R = U * numpy.where(beta_R > 0.0, p.gamma_R_positive, p.gamma_R_negative) * beta_R
    race = 1.0 + p.kappa * (numpy.sqrt(1.0 + 8.0 * K_T / (numpy.pi * J**2)) - 1.0)
    u_R = p.epsilon * u_P * numpy.sqrt(p.D / p.H_R * race**2 + 1.0 - p.D / p.H_R)
    F_N = 0.5 * p.rho * p.A_R * p.f_alpha * (u_R**2 + v_R**2) * numpy.sin(delta - numpy.arctan2(v_R, u_R))
    return (
        (1.0 - p.t_P) * p.rho * n**2 * p.D**4 * K_T - (1.0 - p.t_R) * F_N * numpy.sin(delta),
        -(1.0 + p.a_H) * F_N * numpy.cos(delta),
        -(p.x_R + p.a_H * p.x_H) * F_N * numpy.cos(delta),
    )


def from_velocities(run, window):
    """u, v, r and their slopes, from recorded velocities smoothed by Savitzky–Golay polynomials."""
    dt = run.time[1] - run.time[0]
    velocities = [run[column] for column in ("u_m_s", "v_m_s", "r_rad_s")]
    return [savgol_filter(x, window, 3, deriv=order, delta=dt) for order in (0, 1) for x in velocities]


def from_track(run, window):
    """The same from track and heading alone, smoothed likewise and differentiated once and twice."""
    dt = run.time[1] - run.time[0]
    x, y, psi = (run[column] for column in ("x_m", "y_m", "psi_rad"))
    slopes = (savgol_filter(z, window, 3, deriv=order, delta=dt) for order in (1, 2) for z in (x, y, psi))
    dx, dy, r, ddx, ddy, dr = slopes
    psi = savgol_filter(psi, window, 3)
    c, s = numpy.cos(psi), numpy.sin(psi)
    u, v = dx * c + dy * s, dy * c - dx * s
    # du/dt = d²x/dt² cos(psi) + d²y/dt² sin(psi) + r v
    return u, v, r, ddx * c + ddy * s + r * v, ddy * c - ddx * s - r * u, dr


def hull_forces(run, p, motion):
    """Dimensionless (X, Y, N) of the hull and v', r', from the motion of a recording."""
    u, v, r, du, dv, dr = motion(run)
    X, Y, N = propeller_and_rudder(u, v, r, -run["delta_rad"], run["rev_s"], p)
    X = (p.m + p.m_x) * du - (p.m + p.m_y) * v * r - p.x_G * p.m * r**2 - X
    Y = (p.m + p.m_y) * dv + (p.m + p.m_x) * u * r + p.x_G * p.m * dr - Y
    N = (p.I_zG + p.x_G**2 * p.m + p.J_z) * dr + p.x_G * p.m * (dv + u * r) - N
    U = numpy.hypot(u, v)
    unit = 0.5 * p.rho * p.L * p.d * U**2
    return X / unit, Y / unit, N / (unit * p.L), v / U, r * p.L / U


def fit(runs, p, motion, lags=20):
    """Value and standard error of each coefficient, by name; errors are those of Newey and West."""
    import statsmodels.api as sm

    X, Y, N, v, r = (numpy.concatenate(parts) for parts in zip(*(hull_forces(run, p, motion) for run in runs)))
    surge = numpy.column_stack([-numpy.ones_like(v), v**2, v * r, r**2, v**4])
    cubic = numpy.column_stack([v, r, v**3, v**2 * r, v * r**2, r**3])
    found = {}
    for names, force, features in zip(TERMS.values(), (X, Y, N), (surge, cubic, cubic)):
        result = sm.OLS(force, features).fit(cov_type="HAC", cov_kwds={"maxlags": lags})
        found.update(zip(names, zip(result.params, result.bse)))
    return found
