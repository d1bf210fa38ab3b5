"""The MMG standard model, written from the paper: the rudder angle is positive to starboard here.

Source: H. Yasukawa, Y. Yoshimura, Introduction of MMG standard method for ship maneuvering predictions, J. Mar. Sci.
Technol. 20 (2015), eqs (4)–(24). Nothing of swayaw is used but the numbers of a ship file.
"""

import math
import tomllib
from collections import namedtuple

from scipy.optimize import brentq

Mmg = namedtuple(
    "Mmg",
    "rho L d m x_G I_zG m_x m_y J_z R_0 X_vv X_vr X_rr X_vvvv "
    "Y_v Y_r Y_vvv Y_vvr Y_vrr Y_rrr N_v N_r N_vvv N_vvr N_vrr N_rrr "
    "D x_P t_P w_P0 k_0 k_1 k_2 C_1 C_2_positive C_2_negative "
    "A_R H_R x_R t_R a_H x_H l_R gamma_R_negative gamma_R_positive epsilon kappa f_alpha rate U_0",
)


def read_mmg(file) -> Mmg:
    """The numbers of a ship file with `model = "mmg"`; masses and lengths with dimension."""
    with open(file, "rb") as opened:
        f = tomllib.load(opened)
    particulars, added, propeller, rudder = f["particulars"], f["added_mass"], f["propeller"], f["rudder"]
    rho, L, d = f["water"]["density_kg_m3"], particulars["length_m"], particulars["draught_m"]
    m = rho * particulars["displacement_m3"]
    k_0, k_1, k_2 = propeller["kt"]
    return Mmg(
        rho=rho, L=L, d=d, m=m, x_G=particulars["x_g_m"], I_zG=m * particulars["radius_of_gyration_m"] ** 2,
        m_x=0.5 * rho * L**2 * d * added["m_x"], m_y=0.5 * rho * L**2 * d * added["m_y"],
        J_z=0.5 * rho * L**4 * d * added["J_z"], **f["hull"],
        D=propeller["diameter_m"], x_P=propeller["x_prime"], t_P=propeller["thrust_deduction"],
        w_P0=propeller["wake_fraction"], k_0=k_0, k_1=k_1, k_2=k_2, C_1=propeller["wake_C1"],
        C_2_positive=propeller["wake_C2_positive"], C_2_negative=propeller["wake_C2_negative"],
        A_R=rudder["area_m2"], H_R=rudder["height_m"], x_R=rudder["x_prime"] * L, t_R=rudder["t_R"], a_H=rudder["a_H"],
        x_H=rudder["x_H_prime"] * L, l_R=rudder["l_R_prime"], gamma_R_negative=rudder["gamma_R_negative"],
        gamma_R_positive=rudder["gamma_R_positive"], epsilon=rudder["epsilon"], kappa=rudder["kappa"],
        f_alpha=rudder["f_alpha"], rate=math.radians(rudder["rate_deg_s"]), U_0=particulars["service_speed_m_s"],
    )  # fmt: skip


def accelerations(u, v, r, delta, n, p):
    """(du/dt, dv/dt, dr/dt) about midship, of numbers."""
    U = math.sqrt(u * u + v * v)
    beta = math.atan2(-v, u)
    v_, r_ = v / U, r * p.L / U

    # hull, eqs (7), (8)
    q = 0.5 * p.rho * p.L * p.d * U * U
    X_H = q * (-p.R_0 + p.X_vv * v_**2 + p.X_vr * v_ * r_ + p.X_rr * r_**2 + p.X_vvvv * v_**4)
    vvv, vvr, vrr, rrr = v_**3, v_**2 * r_, v_ * r_**2, r_**3
    Y_H = q * (p.Y_v * v_ + p.Y_r * r_ + p.Y_vvv * vvv + p.Y_vvr * vvr + p.Y_vrr * vrr + p.Y_rrr * rrr)
    N_H = q * p.L * (p.N_v * v_ + p.N_r * r_ + p.N_vvv * vvv + p.N_vvr * vvr + p.N_vrr * vrr + p.N_rrr * rrr)

    # propeller, eqs (9)–(16)
    beta_P = beta - p.x_P * r_
    C_2 = p.C_2_positive if beta_P > 0.0 else p.C_2_negative
    one_less_w = (1.0 - p.w_P0) * (1.0 + (1.0 - math.exp(-p.C_1 * abs(beta_P))) * (C_2 - 1.0))
    J = u * one_less_w / (n * p.D)
    K_T = p.k_0 + p.k_1 * J + p.k_2 * J * J
    X_P = (1.0 - p.t_P) * p.rho * n * n * p.D**4 * K_T

    # rudder, eqs (17)–(24)
    beta_R = beta - p.l_R * r_
    v_R = U * (p.gamma_R_positive if beta_R > 0.0 else p.gamma_R_negative) * beta_R
    eta = p.D / p.H_R
    race = 1.0 + p.kappa * (math.sqrt(1.0 + 8.0 * K_T / (math.pi * J * J)) - 1.0)
    u_R = p.epsilon * u * one_less_w * math.sqrt(eta * race * race + 1.0 - eta)
    F_N = 0.5 * p.rho * p.A_R * p.f_alpha * (u_R**2 + v_R**2) * math.sin(delta - math.atan2(v_R, u_R))
    X_R = -(1.0 - p.t_R) * F_N * math.sin(delta)
    Y_R = -(1.0 + p.a_H) * F_N * math.cos(delta)
    N_R = -(p.x_R + p.a_H * p.x_H) * F_N * math.cos(delta)

    # motion, eq (4): the second and the third are coupled by x_G
    X, Y, N = X_H + X_P + X_R, Y_H + Y_R, N_H + N_R
    a, b, c = p.m + p.m_y, p.x_G * p.m, p.I_zG + p.x_G**2 * p.m + p.J_z
    right_v = Y - (p.m + p.m_x) * u * r
    right_r = N - p.x_G * p.m * u * r
    det = a * c - b * b
    return (
        (X + (p.m + p.m_y) * v * r + p.x_G * p.m * r * r) / (p.m + p.m_x),
        (c * right_v - b * right_r) / det,
        (a * right_r - b * right_v) / det,
    )


def self_propulsion(p: Mmg, model=accelerations) -> float:
    """Shaft speed at which the ship goes straight ahead at her service speed [1/s]."""
    return brentq(lambda n: model(p.U_0, 0.0, 0.0, 0.0, n, p)[0], 0.2 * p.U_0 / p.D, 5.0 * p.U_0 / p.D, xtol=1e-12)
