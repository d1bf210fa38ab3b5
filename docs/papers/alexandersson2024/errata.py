"""The errata of the paper, each with what the program says about it."""
from math import cos, degrees, log10, pi, radians, sin, sqrt

import numpy as np

from program import rms, table

REFERENCE = "wpcc_reference"


def percent(ratio):
    return f"{100 * (ratio - 1):+.1f} %"


class Check:
    """Forces of the reference set at 12 kn of the ship, rudder 10 deg to starboard."""

    def __init__(self, p):
        self.p = p
        self.U, self.T, self.L = (p.number(REFERENCE, k) for k in ("service_speed_m_s", "thrust_N", "length_m"))
        self.unit = 0.5 * p.number(REFERENCE, "density_kg_m3") * self.L**2 * self.U**2
        self.before = p.golden("alexandersson2024_tests")["before tuning"]

    def number(self, key, *index):
        return self.p.number(REFERENCE, key, *index)

    def forces(self, ship=REFERENCE, r_prime=0.0, delta_deg=-10.0, beta_deg=0.0):
        beta = radians(beta_deg)
        return self.p.forces(ship, u=self.U * cos(beta), v=-self.U * sin(beta), r=r_prime * self.U / self.L, delta=radians(delta_deg), thrust=self.T)

    def rudder(self, axis, ship=REFERENCE, **state):
        return self.forces(ship, **state)["parts"]["rudder"][axis]

    def change(self, axis, name, **values):
        """Of the rudder's force, where an input is another."""
        return self.rudder(axis, self.p.variant(REFERENCE, name, **values)) / self.rudder(axis)


# ---------------------------------------------------------------- one function for each group

def tuned_derivatives(c):
    marks = c.p.golden("alexandersson2024")["published fig 9 model markers (x1000 prime)"]["Circle"]
    x, mark, vct = marks["x"][0], marks["NH_model"][0], marks["NH_vct"][0]
    def hull(ship):
        f = c.forces(ship, r_prime=x, delta_deg=0.0)
        return 1e3 * c.p.sum(f, "hull", "rudder_hull_interaction")["N"] / (c.unit * c.L)
    halved = c.p.variant(REFERENCE, "halved", N_r=0.5 * c.number("N_r"))
    yield ("E1", "table 7", "N_r' of the reference set is twice what its regression gave", f"N_H' × 1000 at r' = {x:.3f} with N_r' as printed, and halved",
           f"**confirmed**: {hull(REFERENCE):.3f} and {hull(halved):.3f}; figure 9 has {mark:.3f}, its virtual test {vct:.3f}")

    B, d, C_B = c.number("beam_m"), c.number("draught_m"), c.before["block_coefficient"]
    def N_rdot(k):
        return -pi * (d / c.L) ** 2 * (1 / 12 + 0.017 * C_B * B / d - k * B / c.L)
    yield ("E2", "table 6", "N_rdot' is a quarter of Clarke's formula with 0.0033 B/L in place of 0.33 B/L [Clarke1983]", "the formula, both ways, × 1000",
           f"**confirmed**: {1e3 * N_rdot(0.33):.4f} by Clarke, {1e3 * N_rdot(0.0033):.4f} with the slip, a quarter of it {250 * N_rdot(0.0033):.4f}, table 6 {1e3 * c.number('N_rdot'):.4f}")

    a = c.p.forces(REFERENCE, u=c.U, delta=0.0, thrust=1.5 * c.T)["acceleration"]["u"]
    right = c.p.variant(REFERENCE, "negative_X_udot", X_udot=-c.number("X_udot"))
    b = c.p.forces(right, u=c.U, delta=0.0, thrust=1.5 * c.T)["acceleration"]["u"]
    yield ("E3", "table 6", "X_udot' is positive", "surge acceleration at one and a half times the thrust, as printed over that with the sign turned",
           f"**confirmed**: {percent(a / b)}; the mass in surge is {100 * (1 - b / a):.1f} % too low as printed")


def figure_9(c):
    p = c.p
    marks = p.golden("alexandersson2024")["published fig 9 model markers (x1000 prime)"]
    vct = [m["YH_vct"][i] - m["YH_model"][i] for m in marks.values() for i in range(len(m["x"]))]
    yield ("E4", "figure 9", "the caption exchanges markers and lines: markers are the model", "our rudder and hull at the 13 states, see [figure 9](#figure-9-virtual-captive-tests)",
           f"**confirmed**: we meet the markers to the digits of the drawing; the lines are up to {max(map(abs, vct)):.3f} away in Y_H' × 1000")


def rudder_formulas(c):
    detail = c.p.golden("alexandersson2024")["wPCC rudder detail (one rudder)"][0]
    Re = 0.5 * (c.number("chord_root_m") + c.number("chord_tip_m")) * detail["V_RC"] / c.number("kinematic_viscosity_m2_s")
    ratio = (log10(Re - 2) / (log10(Re) - 2)) ** 2
    factor = c.number("zero_lift_drag_factor")
    line = dict(friction_line='"ittc57"')
    mixed, matched = c.change("X", "ittc_mixed", **line), c.change("X", "ittc_matched", **line, zero_lift_drag_factor=factor / ratio)
    yield ("E5", "(B.8)", "0.075/log10(Re − 2)² is not the ITTC 1957 line 0.075/(log10 Re − 2)²", "both lines; X_R with `friction_line = \"ittc57\"`",
           f"**confirmed**: the ITTC line is {ratio:.2f} times as high at Re = {Re:.3g}. X_R {percent(mixed)} if the printed factor {factor:.2f} is kept, {percent(matched)} with {factor / ratio:.2f}. Line and factor belong together")

    taper = c.number("chord_tip_m") / c.number("chord_root_m")
    C_DC, rho = 0.1 + 1.6 * taper, c.number("density_kg_m3")
    drag = 0.5 * rho * c.number("area_covered_m2") * C_DC * detail["V_RC"] ** 2
    yield ("E6", "(26), (33) and (35), (B.4)", "C_DC is two quantities: drag of the flow across the tip, and of the covered part", "what (35) would give with the C_DC of (33)",
           f"**confirmed**: {drag:.0f} N of drag from the covered part of one rudder, which has {detail['D_R']:.1f} N in all")

    AR = 2 * c.number("span_m") ** 2 / c.number("area_m2")
    right, extracted = 1.8 * pi * AR / (sqrt(AR**2 + 4) + 1.8), 1.8 * pi * AR / sqrt(AR**2 + 4 + 1.8)
    yield ("E7", "(31)", "the denominator is cos Ω √(AR²/cos⁴Ω + 4) + 1.8, not one root over all of it", "slope of the lift both ways; figure 9",
           f"**confirmed**: {right:.3f} and {extracted:.3f} 1/rad, {percent(extracted / right)}; only the first meets the Y_R of figure 9")

    before = c.before
    yield ("E8", "table 5", "c_r and c_t are not those of the drawing, the taper is upside down", "Y_R with the chords of the drawing",
           f"**confirmed**: taper {taper:.3f} instead of {before['chord_tip_m'] / before['chord_root_m']:.3f}; Y_R {percent(c.change('Y', 'chords', chord_root_m=before['chord_root_m'], chord_tip_m=before['chord_tip_m']))} with the drawing")
    covered = c.number("diameter_m") / c.number("span_m") * c.number("area_m2")
    share = c.number("area_covered_m2") / covered
    yield ("E9", "table 5, figure 6", "A_RC is not D/b_R of the area, but a factor of it", "the ratio; Y_R without the factor",
           f"**confirmed**: {share:.4f} D/b_R A_R; Y_R {percent(c.change('Y', 'covered', area_covered_m2=covered))} without it")
    distance = before["propeller_x_m"] - before["rudder_x_m"]
    yield ("E10", "table 5", "w_f, x and x_R are tuned, not measured", f"wake {before['wake_fraction']}, x = {distance:.3f} m, x_R = {before['rudder_x_m']} m, one at a time",
           f"**confirmed**: Y_R {percent(c.change('Y', 'wake', wake_fraction=before['wake_fraction']))}, Y_R {percent(c.change('Y', 'distance', propeller_distance_m=distance))}, N_R {percent(c.change('N', 'lever', rudder__x_m=before['rudder_x_m']))}")


def twin_screw(c):
    y = c.before["rudder_y_m"]
    twin = c.p.variant(REFERENCE, "twin", rudder__y_m=f"[{-y}, {y}]")
    turning = dict(r_prime=-0.3)
    yield ("E11", "(B.20), (B.27)", "−r y_R of the inflow is printed, but left out of the calculations", f"Y_R at r' = −0.3 with `y_m = [−{y}, {y}]`",
           f"**confirmed**: {percent(c.rudder('Y', twin, **turning) / c.rudder('Y', **turning))}; figure 9 is met without it")
    yield ("E12", "(22)", "the couple −y_R X_R of two rudders is missing", "N_R with it, straight ahead", f"**confirmed**: {percent(c.rudder('N', twin) / c.rudder('N'))}")


def gap(c):
    delta_lim, s = c.number("gap_angle_rad"), c.number("gap_strength")
    zero = degrees(delta_lim + sqrt(-1 / s))
    at_35 = c.rudder("Y", delta_deg=35.0)
    clipped = c.rudder("Y", c.p.variant(REFERENCE, "clipped_reference", rudder__gap_factor='"clipped"'), delta_deg=35.0)
    yield ("E13", "(30)", "the gap factor has no floor; the lift turns round", "Y_R at 35 deg, published and with `gap_factor = \"clipped\"`",
           f"**confirmed**: zero at {zero:.1f} deg, {1 + s * (radians(35) - delta_lim) ** 2:.2f} at 35 deg, where Y_R is {at_35:.2f} N, to the wrong side, and {clipped + 0.0:.2f} N when clipped; see [hard turns](#hard-turns)")


def readings(c):
    f = c.forces()
    yield ("E14", "(17), (21)", "one inflow angle, that of the race, serves both parts of the rudder; axial speed outside is u (1 − w_f)", "figure 9 with that reading", "**confirmed**: all Y_R and N_R are met")
    yield ("E15", "(B.17)–(B.24)", "race, mixing and loss of lift can be read in several ways", "figure 9, and each step inside the rudder against an independent program (`pi_published_test.cpp`)", "**confirmed** in the reading of `propeller_race.hpp`")
    R, I = f["parts"]["rudder"], f["parts"]["rudder_hull_interaction"]
    lever = I["Y"] * c.number("x_H") / I["N"]
    marks = c.p.golden("alexandersson2024")["published fig 9 model markers (x1000 prime)"]["Rudder angle"]
    share = marks["NH_model"][0] / marks["NR_model"][0]
    yield ("E16", "(12), (13)", "x_H is the ratio N_RHI/N_R, no lever as in the MMG model", "N_RHI/N_R, and N_H/N_R of figure 9 at 15 deg of rudder, where the hull has nothing of its own",
           f"**confirmed**: {I['N'] / R['N']:.5f} and {share:.5f}; as a lever in metres it would make {100 * lever:.1f} % of the moment")
    P = f["parts"]["propeller"]
    yield ("E17", "(10), (40)", "(40) subtracts the rudder only, (10) lacks its sign of equality", "what would be left in the hull's force",
           f"**confirmed**: X_P = {P['X']:.2f} N beside X_H = {f['parts']['hull']['X']:.2f} N, and {I['Y'] / R['Y']:.3f} Y_R. The regression itself was not run")


def hull_terms(c):
    marks = c.p.golden("alexandersson2024")["published fig 9 model markers (x1000 prime)"]["Circle"]
    shares = [Y_H / Y_R for Y_H, Y_R in zip(marks["YH_model"], marks["YR_model"])]
    d, fig = c.p.golden("alexandersson2024")["KVLCC2 hull derivatives"], c.p.golden("alexandersson2024")["KVLCC2 recovered from fig 17"]
    yield ("E18", "(A.2), (A.3)", "Y_0', N_0', Y_r' are printed as free, but fixed to 0 for the wPCC", "Y_H/Y_R of figure 9 in the circle tests: without Y_r' it is a_H; Y_v' × 1000 of the KVLCC2 fitted without and with Y_r'",
           f"**confirmed**: {min(shares):.5f} to {max(shares):.5f}, a_H = {c.number('a_H'):.5f}. KVLCC2: {1e3 * d['base (paper form)']['Yv']:.1f} and {1e3 * d['+Yr']['Yv']:.1f}, figure 17 has {1e3 * fig['PI']['Yv']:.1f}, which suggests that Y_r' was free there (fits of an independent program)")
    munk, m_x, m_y = c.number("Y_vdot") + abs(c.number("X_udot")), abs(c.number("X_udot")), -c.number("Y_vdot")
    yield ("E19", "(1)–(3)", "no centripetal force and no Munk moment of the entrained water; the derivatives hold them", "derivation: what the derivatives × 1000 hold, m_y' of X_vr', −m_x' of Y_r', Munk's Y_vdot' − X_udot' of N_v'",
           f"**confirmed**: X_vr' = {1e3 * c.number('X_vr'):.2f} is {1e3 * (c.number('X_vr') - m_y):.2f} + {1e3 * m_y:.2f}, and an MMG table would have the first; Y_r' = 0 is {1e3 * m_x:.2f} - {1e3 * m_x:.2f}; of N_v' = {1e3 * c.number('N_v'):.2f}, {1e3 * munk:.2f} is Munk's, in an MMG table too")


def primes(c):
    L = c.L
    other = c.p.variant(REFERENCE, "L3", Y_rdot=c.number("Y_rdot") / L, N_vdot=c.number("N_vdot") / L)
    def first(ship, *options):
        return c.p.json("simulate", c.p.ship(ship), "--zigzag", "10/10", "--first", "port", *options)["overshoot_deg"][0]
    yield ("E20", "table 1", "Y_rdot and N_vdot need ½ρL⁴; L³ and L⁵ were printed", "first 10/10 overshoot if Y_rdot', N_vdot' went with L³",
           f"**confirmed**: {first(other):.2f} instead of {first(REFERENCE):.2f} deg; no effect where primes are not left")
    still = c.p.variant(REFERENCE, "u_prime", perturbed_speed_froude=0.0)
    T = c.p.json("simulate", c.p.ship(REFERENCE), "--zigzag", "10/10")["thrust_N"], c.p.json("simulate", c.p.ship(still), "--zigzag", "10/10")["thrust_N"]
    yield ("E21", "(36)", "u' counts from U_0 = 0.02 √(gL)", "thrust of self-propulsion with it and with U_0 = 0; first 10/10 overshoot at each",
           f"**confirmed**: {T[0]:.2f} and {T[1]:.2f} N, {first(REFERENCE):.3f} and {first(still):.3f} deg; it enters the surge force only")
    yield ("E22", "section 3", "not only position and heading are measured: the filter takes accelerations too", "needs the recordings, which are not public", "not run")


def kvlcc2(c):
    p = c.p
    ship = "kvlcc2_pi"
    U, L = p.number(ship, "service_speed_m_s"), p.number(ship, "length_m")
    wrong = p.variant(ship, "wake_without_U", propeller__x_m=p.number_in(ship, "propeller", "x_m") * U)
    state = dict(u=U * cos(0.1), v=-U * sin(0.1), r=0.3 * U / L, delta=radians(-10.0), thrust=40.0)
    Y = [p.forces(s, **state)["parts"]["rudder"]["Y"] for s in (ship, wrong)]
    yield ("E23", "wake change of section 5.5, authors' code", "beta_P = beta − x_P r lacks 1/U", f"Y_R of the KVLCC2 at {U:.3f} m/s, r' = 0.3, drift 0.1 rad, both ways",
           f"**confirmed** as an error of the formula: {percent(Y[1] / Y[0])}; small, for U is near 1 m/s")
    fig = p.golden("alexandersson2024_tests")["figure 17"]
    beta = np.array(fig["beta_deg"])
    near = (np.abs(beta) <= 12)
    def errors(factor):
        return ", ".join(f"{m} " + "/".join(f"{rms((np.array(fig[f'{m}.{k}']) - factor * np.array(fig[f'CMT_as_plotted.{k}']))[near]) / rms(factor * np.array(fig[f'CMT_as_plotted.{k}'])[near]):.2f}"
                                          for k in ("Y_D", "N_D")) for m in ("PI", "PU"))
    VV = fig["speed_squared"]
    yield ("E24", "figure 17", f"captive points are divided by the speed twice, so too small by a factor of {VV:.4f}", "rms error of Y_D/N_D within 12 deg of drift over that of the captive tests: as drawn, and with the points put right",
           f"**confirmed**: {errors(1.0)} as drawn; {errors(VV)} with the points put right. The curves are as drawn, of a model at another speed. The paper understates its own PI model")
    yield ("E25", "recordings of section 5.5", "columns u, v of the tank's files are earth-fixed, column 7 is the yaw rate in deg/s", "needs those files", "not run here")


def errata(p):
    c = Check(p)
    groups = (tuned_derivatives, figure_9, rudder_formulas, twin_screw, gap, readings, hull_terms, primes, kvlcc2)
    return table("# | where | erratum | our check | found", [list(row) for group in groups for row in group(c)], "llll")
