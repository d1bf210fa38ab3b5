"""Computes the tables and curves of docs/papers/alexandersson2024.md with the program.

    tables.py PROGRAM PROJECT_FOLDER FOLDER_FOR_RESULTS

Every number comes from the program, from a ship file, or from the golden files of the project.
"""
import json
import re
import subprocess
import sys
from math import cos, degrees, radians, sin
from pathlib import Path

import numpy as np

import errata
from program import Program, rms, table

SETS = {"Reference": "wpcc_reference", "PI": "wpcc_pi", "PU": "wpcc_pu"}
ZIGZAGS = {"10/10": "zigzag10/10", "20/20": "zigzag20/20"}


def at(curve, time):
    return np.interp(time, curve[0], curve[1])


def overshoots(curve, angle):
    """Largest heading beyond the switch angle, between passages through zero."""
    psi, result, start = np.abs(curve[1]), [], 0
    for end in [*np.flatnonzero(np.diff(np.sign(curve[1]))) + 1, len(psi)]:
        peak = start + int(np.argmax(psi[start:end])) if end > start else start
        if psi[peak] > angle and peak < len(psi) - 1:
            result.append(psi[peak] - angle)
        start = end
    return result


# ---------------------------------------------------------------- figure 10

def mean_thrust(p, drawn, speed, end):
    """Recorded, or where there is no record, that of self-propulsion of the reference set."""
    if "thrust" not in drawn:
        return p.json("linearize", p.ship("wpcc_reference"), "--speed", speed)["operating_point"]["thrust_N"]
    t, T = map(np.array, drawn["thrust"])
    return np.mean(T[t < end])


def zigzags(p, results):
    """Closed-loop zigzags beside the test and beside the curves of the paper."""
    figure, curves, rows = p.golden("alexandersson2024_figure_10"), {}, []
    tests = p.golden("alexandersson2024_tests")["figure 10"]
    for name, key in ZIGZAGS.items():
        angle = float(name.split("/")[0])
        drawn, test = figure[key], tests[key]
        psi_end, speed = test["test.psi_deg"][0][-1], drawn["test.V"][1][0]
        curves[name] = {"test": {k.removeprefix("test."): v for k, v in test.items()}}
        rows.append([name, "test", *(f"{x:.2f}" for x in overshoots(test["test.psi_deg"], angle)[:2]), "", "", "", ""])
        for model, file in SETS.items():
            options = ["--zigzag", name, "--first", "port", "--speed", speed, "--duration", 45, "--step", 0.05, "--out", p.folder / "run.csv"]
            options += ["--thrust", mean_thrust(p, drawn, speed, psi_end)]
            summary = p.json("simulate", p.ship(file), *options)
            run = p.recording(p.folder / "run.csv")
            ours = {"psi_deg": np.degrees(run["psi_rad"]), "beta_deg": np.degrees(np.arctan2(-run["v_m_s"], run["u_m_s"])), "r": run["r_rad_s"]}
            curves[name][model] = {"time": run["time_s"].tolist(), **{k: v.tolist() for k, v in ours.items()},
                                   "paper": {k: drawn[f"{model}.{k}"] for k in ours}}
            grid = np.arange(0.0, min(c[0][-1] for c in (*test.values(), *(drawn[f"{model}.{k}"] for k in ours))), 0.1)
            def error(quantity, curve):
                return rms(np.interp(grid, run["time_s"], ours[quantity]) - at(curve, grid))
            def both(quantity, unit=1.0):
                """Of our run, and of the curve in the paper."""
                measured = test[f"test.{quantity}"]
                printed = rms(at(drawn[f"{model}.{quantity}"], grid) - at(measured, grid))
                return f"{unit * error(quantity, measured):.2f} ({unit * printed:.2f})"
            printed = overshoots(drawn[f"{model}.psi_deg"], angle)
            rows.append([name, model, *(f"{x:.2f} ({y:.2f})" for x, y in zip(summary["overshoot_deg"][:2], printed)),
                         both("psi_deg"), both("beta_deg"), both("r", 1e3), f"{error('psi_deg', drawn[model + '.psi_deg']):.2f}"])
    results["zigzags"] = table("zigzag | set | overshoot 1 [deg] | overshoot 2 [deg] | psi − test, rms [deg] | beta − test [deg] | r − test [mrad/s] | psi − curve of the paper [deg]",
                               rows, "lrrrrrr")
    return curves


# ---------------------------------------------------------------- figures 11 to 13

def along_tests(p, results):
    """Forces of the three sets at the states of the tests, every half second."""
    figure, tests = p.golden("alexandersson2024_figure_10"), p.golden("alexandersson2024_tests")["figure 10"]
    curves, rows, split = {}, [], []
    for name, key in ZIGZAGS.items():
        test, V = tests[key], figure[key]["test.V"]
        end = min(c[0][-1] for c in (*test.values(), V))
        times = np.arange(0.0, end, 0.5)
        curves[name] = {"time": times.tolist()}
        for model, file in SETS.items():
            thrust = p.number(file, "thrust_N")
            series = {k: [] for k in ("Y_D", "N_D", "N_R", "N_H", "N_v", "N_r", "Y_v")}
            for t in times:
                beta, U = radians(at(test["test.beta_deg"], t)), at(V, t)
                state = dict(u=U * cos(beta), v=-U * sin(beta), r=at(test["test.r"], t), delta=-radians(at(test["test.minus_delta_deg"], t)),
                             thrust=np.interp(t, *figure[key]["thrust"]) if "thrust" in figure[key] else thrust)
                f, adrift = p.forces(file, **state), p.forces(file, **(state | {"r": 0.0}))
                rudder = p.sum(f, "rudder", "rudder_hull_interaction")
                hull, drift = f["parts"]["hull"], adrift["parts"]["hull"]
                for k, x in zip(series, (f["total"]["Y"], f["total"]["N"], rudder["N"], hull["N"], drift["N"], hull["N"] - drift["N"], drift["Y"])):
                    series[k].append(x)
            curves[name][model] = series
        ref = curves[name]["Reference"]
        for model in ("PI", "PU"):
            off = {k: rms(np.array(curves[name][model][k]) - np.array(ref[k])) / rms(ref[k]) for k in ("Y_D", "N_D", "N_H", "N_R")}
            rows.append([name, model, *(f"{100 * off[k]:.0f} %" for k in ("Y_D", "N_D", "N_H", "N_R"))])
        for model in SETS:
            c = curves[name][model]
            split.append([name, model, *(f"{rms(c[k]):.2f}" for k in ("Y_v", "N_v", "N_r"))])
    results["along"] = table("zigzag | set | Y_D | N_D | N_H | N_R, with what it induces", rows, "lrrrr")
    results["drift_and_yaw"] = table("zigzag | set | Y_H of drift [N] | N_H of drift [N m] | N_H of yaw [N m]", split, "lrrr")
    return curves


# ---------------------------------------------------------------- figure 9

def captive(p, results):
    """The states of the virtual captive tests. N_r' is half of table 7, as the figure was drawn."""
    reference = p.variant("wpcc_reference", "figure_9", N_r=0.5 * p.number("wpcc_reference", "N_r"))
    U, L = p.number(reference, "service_speed_m_s"), p.number(reference, "length_m")
    q = 0.5 * p.number(reference, "density_kg_m3") * L**2 * U**2
    golden = p.golden("alexandersson2024")["published fig 9 model markers (x1000 prime)"]
    curves, rows = {}, []
    errors = {k: [[], []] for k in ("Y_H", "N_H", "Y_D", "N_D", "Y_R", "N_R")}
    for test, marks in golden.items():
        panel = {"x": marks["x"], "markers": {}, "vct": {}, "ours": {}}
        worst = 0.0
        for i, x in enumerate(marks["x"]):
            beta = radians(x) if test == "Drift angle" else 0.0
            T = q * 1e-3 * (marks["XD_model"][i] - marks["XH_model"][i] - marks["XR_model"][i]) / (1.0 - p.number(reference, "thrust_deduction"))
            delta = radians(x if test == "Rudder angle" else -10.0 if test == "Thrust variation" else 0.0)
            f = p.forces(reference, u=U * cos(beta), v=-U * sin(beta), r=x * U / L if test == "Circle" else 0.0, delta=delta, thrust=T)
            hull, rudder = p.sum(f, "hull", "rudder_hull_interaction"), f["parts"]["rudder"]
            for name, part in (("H", hull), ("R", rudder), ("D", p.sum(f, "hull", "rudder_hull_interaction", "rudder"))):
                for axis, unit in (("Y", q), ("N", q * L)):
                    ours, mark, vct = 1e3 * part[axis] / unit, marks[f"{axis}{name}_model"][i], marks[f"{axis}{name}_vct"][i]
                    worst = max(worst, abs(ours - mark))
                    errors[f"{axis}_{name}"][0].append(ours - vct)
                    errors[f"{axis}_{name}"][1].append(vct)
                    for kind, value in (("ours", ours), ("markers", mark), ("vct", vct)):
                        panel[kind].setdefault(f"{axis}_{name}", []).append(value)
        curves[test] = panel
        rows.append([test, len(marks["x"]), f"{worst:.1e}"])
    results["figure_9"] = table("virtual test | states | largest difference of Y and N from a marker [primes × 1000]", rows, "rr")
    results["figure_9_vct"] = table("rms of the reference set against the virtual tests, of their rms | " + " | ".join(errors),
                                    [["all states", *(f"{100 * rms(a) / rms(b):.1f} %" for a, b in errors.values())]], "rrrrrr")
    return curves


# ---------------------------------------------------------------- figure 14

def wind_state(p, results):
    """Drift without yaw rate and rudder: what a steady side wind does to the ship."""
    golden = p.golden("alexandersson2024")["published fig 14"]
    V, T, last = golden["V"], golden["thrust_total"], golden["beta_deg"]
    def state(file, beta_deg):
        beta = radians(beta_deg)
        return p.forces(file, u=V * cos(beta), v=-V * sin(beta), r=0.0, delta=0.0, thrust=T)
    angles = np.linspace(-last, last, 21)
    curves = {"beta_deg": angles.tolist()}
    rows, split = [], []
    for beta in (2, 4, 6, 8, 10):
        for model, file in SETS.items():
            f = state(file, beta)
            shares = [f"{100 * f['parts'][part][axis] / f['total'][axis]:.0f} %" if part in f["parts"] else "" for axis in "YN"
                      for part in ("hull", "rudder", "rudder_hull_interaction")]
            rows.append([beta, model, f"{f['total']['Y']:.3f}", *shares[:3], f"{f['total']['N']:.3f}", *shares[3:]])
    for model, file in SETS.items():
        fs = [state(file, b) for b in angles]
        curves[model] = {axis: [f["total"][axis] for f in fs] for axis in "YN"}
        end = fs[-1]
        curves[model]["parts"] = {k: {axis: v[axis] for axis in "YN"} for k, v in end["parts"].items()}
        split.append([model, *(f"{end['parts'][k]['N']:.3f}" if k in end["parts"] else "" for k in ("hull", "rudder", "rudder_hull_interaction")),
                      f"{end['total']['N']:.3f}", f"{golden[model]['N_D']:.3f}", f"{end['total']['Y']:.3f}", f"{golden[model]['Y_D']:.3f}"])
    results["wind_state"] = table("beta [deg] | set | Y_D [N] | hull | rudder | induced | N_D [N m] | hull | rudder | induced", rows, "lrrrrrrrr")
    results["figure_14"] = table("set | N of the hull [N m] | of the rudders | induced on the hull | N_D | printed | Y_D [N] | printed", split, "rrrrrrr")
    return curves


def parameter_drift(p, results):
    """The side wind of figure 14 with the hulls of table 8, from differently smoothed recordings."""
    golden, table_8 = p.golden("alexandersson2024")["published fig 14"], p.golden("alexandersson2024_tests")["table 8"]
    V, T, beta = golden["V"], golden["thrust_total"], radians(golden["beta_deg"])
    rows = []
    for model, file in (("PI", "wpcc_pi"), ("PU", "wpcc_pu")):
        for noise, hulls in table_8.items():
            keys = {k: f"{k[0]}_{k[1:]}" for k in hulls[model]}
            ship = p.variant(file, f"{file}_{noise}", **{keys[k]: x for k, x in hulls[model].items()})
            total = p.forces(ship, u=V * cos(beta), v=-V * sin(beta), delta=0.0, thrust=T)["total"]
            rows.append([model, noise.removeprefix("SNR"), *(f"{1e3 * hulls[model][k]:.3f}" for k in ("Yv", "Nv", "Nr")), f"{total['Y']:.2f}", f"{total['N']:.2f}"])
    results["table_8"] = table("set | assumed signal over noise | Y_v' × 1000 | N_v' × 1000 | N_r' × 1000 | Y_D [N] | N_D [N m]", rows, "rrrrrr")


# ---------------------------------------------------------------- linear indices

def linear(p, results):
    golden = p.golden("alexandersson2024")
    rows, bare = [], []
    for model, file in SETS.items():
        d = p.json("linearize", p.ship(file))
        alone = {k: sum(part[k] for name, part in d["parts"].items() if not name.startswith("rudder")) for k in ("a1", "b1", "a2", "b2")}
        bare.append([model, *(f"{m['a1'] * m['b2'] - m['a2'] * m['b1']:.2f}" for m in (d, alone))])
        other = golden.get(f"wPCC linear {model} 12 kn")
        names = {"T1": "T1_prime", "T2": "T2_prime", "T3w": "T3_prime", "Kw": "K_prime"}
        off = f"{max(abs(d[a] / other[b] - 1.0) for a, b in names.items()):.0e}" if other else "none to compare"
        s, t = d["sname"], d["dimensional"]
        c = s["Y_v"] * (s["N_r"] - s["m"] * s["x_G"]) - s["N_v"] * (s["Y_r"] - s["m"])
        rows.append([model, *(f"{d[k]:.4f}" for k in ("T1", "T2", "T3b", "T3w", "Kb", "Kw")), f"{t['T1_s']:.2f}", f"{t['K_r_per_s']:.4f}", f"{c:.3e}",
                     "stable" if d["stable"] else "unstable", off])
    results["linear"] = table("set | T1' | T2' | T3b' | T3w' | Kb | Kw' | T1 [s] | K [1/s] | c' | course | largest relative difference from the independent program",
                              rows, "rrrrrrrrrlr")
    results["bare_hull"] = table("a1 b2 − a2 b1, positive on a stable course | with rudders amidships | without rudders", bare, "rr")


# ---------------------------------------------------------------- hard turns

def turn_text(p, ship, rudder, *options):
    try:
        d = p.json("simulate", p.ship(ship), "--turn", rudder, *options)
    except subprocess.CalledProcessError as refusal:
        return re.sub(r".*loses her way at (\d+\.\d).*", r"way lost at \1 s", refusal.stderr.strip())
    if d["final_diameter_m"] is None:
        return "no steady turn"
    return f"{d['final_diameter_m'] / p.number(ship, 'length_m'):.2f} L, {degrees(d['final_drift_rad']):.0f} deg, {100 * d['final_speed_m_s'] / d['approach_speed_m_s']:.0f} %"


def hard_turn(p, results):
    """What happens at 35 deg of rudder."""
    run = p.folder / "hard_turn.csv"
    p.run("simulate", p.ship("wpcc_pi"), "--turn", 35, "--duration", 14.8, "--step", 2, "--out", run, "--forces")
    c = p.recording(run)
    U = np.hypot(c["u_m_s"], c["v_m_s"])
    beta, r_prime = np.degrees(np.arctan2(-c["v_m_s"], c["u_m_s"])), c["r_rad_s"] * p.number("wpcc_pi", "length_m") / U
    results["hard_turn"] = table("t [s] | u [m/s] | drift [deg] | r' | thrust less deduction [N] | X of the hull [N] | X of the rudders [N] | N of the hull [N m] | N of the rudders [N m]",
                                 [[f"{t:.0f}", f"{u:.3f}", f"{b:.1f}", f"{r:.3f}", *(f"{c[k][i]:.1f}" for k in ("X_propeller_N", "X_hull_N", "X_rudder_N", "N_hull_N_m", "N_rudder_N_m"))]
                                  for i, (t, u, b, r) in enumerate(zip(c["time_s"], c["u_m_s"], beta, r_prime))], "rrrrrrrr")


def hard_turns(p, results):
    clipped = p.variant("wpcc_pi", "clipped", rudder__gap_factor='"clipped"')
    angles = (10, 20, 25, 30, 33, 34, 35)
    rows = [[name, *(turn_text(p, ship, a) for a in angles)]
            for name, ship in (*SETS.items(), ("PI, gap_factor = \"clipped\"", clipped))]
    results["turns"] = table("set | " + " | ".join(f"{a} deg" for a in angles), rows, "r" * len(angles))
    T, rows = p.number("wpcc_reference", "thrust_N"), []
    for factor in (1.0, 1.5, 2.0, 3.0):
        more = ["--thrust", factor * T]
        rows.append([f"{factor:.1f}", turn_text(p, "wpcc_reference", 30, *more), turn_text(p, clipped, 35, *more)])
    results["turns_thrust"] = table("thrust over that of self-propulsion | Reference, 30 deg | PI, clipped, 35 deg", rows, "rr")


if __name__ == "__main__":
    p = Program(Path(sys.argv[1]), Path(sys.argv[2]), Path(sys.argv[3]))
    results = {}
    curves = {"figure 10": zigzags(p, results), "figure 11": along_tests(p, results), "figure 9": captive(p, results), "figure 14": wind_state(p, results)}
    parameter_drift(p, results)
    linear(p, results)
    hard_turn(p, results)
    hard_turns(p, results)
    results["errata"] = errata.errata(p)
    for name, text in results.items():
        (p.folder / f"{name}.md").write_text(text)
    (p.folder / "curves.json").write_text(json.dumps(curves))
