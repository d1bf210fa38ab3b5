#!/usr/bin/env python3
"""Writes ships/kcs.toml: the captive set of KCS as several public simulators carry it, in the form of the MMG standard.

    docs/results/kcs_ship.py > ships/kcs.toml

There the hull forces are written on the drift angle beta = -v', surge and sway terms contain the added masses (X_br - m_y, Y_r - m_x)."""
rho, L, B, d, C_B = 1025.0, 230.0, 32.2, 10.8, 0.651
half = 0.5 * L * L * d
m_x, m_y, J_z = 1790.85 / half, 44324.18 / half, 140067300 / (half * L * L)
D_P, aspect = 7.9, 2.164
print(f"""# KCS, container ship, full scale. Captive tests as several public simulators carry them (Ybbb = 1.7179,
# Xbr_minus_my = -0.1084, self-propulsion after Yoshimura, SIMMAN 2008); the original was not at hand. Made by docs/results/kcs_ship.py. A model of three degrees of freedom: no heel.
# The rudder area L d/54.86 holds the fixed part.
name = "KCS"
model = "mmg"

[water]
density_kg_m3 = {rho:g}

[particulars]
length_m = {L:g}
beam_m = {B:g}
draught_m = {d:g}
displacement_m3 = {C_B * L * B * d:.6g}
x_g_m = -3.404
radius_of_gyration_m = {0.25 * L:g}
service_speed_m_s = 12.35

[added_mass]
m_x = {m_x:.6g}
m_y = {m_y:.6g}
J_z = {J_z:.6g}

[hull]
R_0 = 0.0167
X_vv = -0.0549
X_vr = {-(m_y - 0.1084):.6g}                    # -(X_br), X_br - m_y = -0.1084
X_rr = -0.0120
X_vvvv = -0.0417
Y_v = -0.2252
Y_r = {0.0398 + m_x:.6g}                     # Y_r - m_x = 0.0398
Y_vvv = -1.7179
Y_vvr = -0.4832
Y_vrr = -0.8341
Y_rrr = -0.0050
N_v = -0.1111
N_r = -0.0465
N_vvv = -0.1752
N_vvr = -0.6168
N_vrr = -0.0512
N_rrr = -0.0387

[propeller]
diameter_m = {D_P:g}
x_prime = -0.4565
thrust_deduction = 0.207
wake_fraction = 0.355
kt = [0.5228, -0.4390, -0.0609]
wake_C1 = 1                               # the wake there is constant
wake_C2_positive = 1
wake_C2_negative = 1

[rudder]
area_m2 = {L * d / 54.86:.5g}
height_m = {D_P / 0.7979:.5g}
x_prime = -0.5
t_R = 0.258
a_H = 0.361
x_H_prime = -0.436
l_R_prime = -0.755
gamma_R_negative = 0.338
gamma_R_positive = 0.492
epsilon = 0.956
kappa = 0.633
f_alpha = {6.13 * aspect / (2.25 + aspect):.5g}
rate_deg_s = 2.32                         # of the ship; the recorded angle is used
max_angle_deg = 35

[confidence]
coefficients = 0.1""")
