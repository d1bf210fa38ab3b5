#!/usr/bin/env python3
"""Helper of the scripts make_*_diagnosis.sh: prepares recordings and turns the JSON of `swayaw diagnose` into tables. Standard library only.

    diagnosis.py prepare IN.csv OUT.csv [--every N] [--drop COLUMNS] [--rename OLD:NEW,...] [--from S] [--to S] [--key "KEY = VALUE"]
    diagnosis.py wind IN.csv [--from S] [--to S]            mean of the measured wind: speed and direction of the mean force, JSON
    diagnosis.py found LABEL=FILE.json...                   verdict and effects, one row each
    diagnosis.py surroundings FILE.json...                  wind found in each part of the runs beside RUN.wind.json, the measured one
    diagnosis.py budget LABEL=FILE.json...                  the missing force by what it follows
    diagnosis.py instruments LABEL=FILE.json...             errors of instruments that were told from none
    diagnosis.py scales CHECK.json CHANNEL                  scale of a channel, run by run, by `swayaw check --json`
    diagnosis.py track RUN.csv...                           way made good by position over way by the speed columns, run by run and altogether
    diagnosis.py candidates FILE.json [MOST]                the ranking
    diagnosis.py numbers BEFORE.toml AFTER.toml KEY...      values of a ship file and of the one refitted
    diagnosis.py zeros RUN.csv...                           zero of the gyro: slope of (integral of r) - psi
    diagnosis.py roll RUN.csv...                            roll acceleration by regression on roll, its rate and the side acceleration
    diagnosis.py lag RUN.csv...                             yaw acceleration by regression on the order, by how late the order is taken
    diagnosis.py errors FILE.json                           replays before, refitted and after, used and held-out runs
    diagnosis.py picture PAGE.html OUT.svg                  the first picture of a page"""
import argparse
import base64
import csv
import json
import math
import re
import sys

SHOWN = ["heading", "yaw_rate", "drift", "speed", "position"]


# ---------------------------------------------------------------- recordings

def table_of(path):
    lines = open(path, encoding="utf-8").read().splitlines()
    head = [line for line in lines if line.startswith("#")]
    rows = list(csv.reader(line for line in lines if not line.startswith("#")))
    return head, rows[0], rows[1:]


def within(rows, a):
    low = -math.inf if a.begin is None else a.begin
    high = math.inf if a.end is None else a.end
    return [row for row in rows if low <= float(row[0]) <= high]


def prepare(a):
    head, columns, rows = table_of(a.file)
    dropped = set(a.drop.split(",")) if a.drop else set()
    renamed = dict(pair.split(":") for pair in a.rename.split(",")) if a.rename else {}
    kept = [i for i, name in enumerate(columns) if name not in dropped]
    with open(a.out, "w", encoding="utf-8") as out:
        for line in head + [f"# {key}" for key in a.key]:
            print(line, file=out)
        print(",".join(renamed.get(columns[i], columns[i]) for i in kept), file=out)
        for row in within(rows, a)[:: a.every]:
            print(",".join(row[i] for i in kept), file=out)


def wind(a):
    """Steady wind of the same mean force: the mean of V² in both directions."""
    _, columns, rows = table_of(a.file)
    speed, direction = columns.index("wind_speed_m_s"), columns.index("wind_from_rad")
    rows = within(rows, a)
    north = sum(float(r[speed]) ** 2 * math.cos(float(r[direction])) for r in rows) / len(rows)
    east = sum(float(r[speed]) ** 2 * math.sin(float(r[direction])) for r in rows) / len(rows)
    mean = sum(float(r[speed]) for r in rows) / len(rows)
    spread = math.sqrt(sum((float(r[speed]) - mean) ** 2 for r in rows) / len(rows))
    json.dump({"wind_speed_m_s": math.sqrt(math.hypot(north, east)), "wind_from_rad": math.atan2(east, north) % (2 * math.pi), "spread_m_s": spread}, sys.stdout)


def track(paths):
    """Way between positions ten samples apart, over the same way by speed and heading. Runs that overlap in time are counted once."""
    print("| run | way by position over way by speed |\n| --- | ---: |")
    whole = {}
    for path in paths:
        _, columns, rows = table_of(path)
        place = [columns.index(c) for c in ("time_s", "x_m", "y_m", "ug_m_s", "vg_m_s", "psi_rad")]
        samples = [tuple(float(row[i]) for i in place) for row in rows]
        whole.update((s[0], s) for s in samples)
        print(f"| {path.rsplit('/', 1)[-1]} | {way_ratio(samples):.4f} |")
    print(f"| altogether | {way_ratio([whole[t] for t in sorted(whole)]):.4f} |")


def way_ratio(samples, apart=10):
    by_position = by_speed = 0.0
    for i in range(0, len(samples) - apart, apart):
        piece = samples[i : i + apart + 1]
        if piece[-1][0] - piece[0][0] > 0.6 * apart:
            continue  # a gap between runs
        north = east = 0.0
        for a, b in zip(piece, piece[1:]):
            h, u, v, psi = b[0] - a[0], a[3], a[4], a[5]
            north += h * (u * math.cos(psi) - v * math.sin(psi))
            east += h * (u * math.sin(psi) + v * math.cos(psi))
        by_position += math.hypot(piece[-1][1] - piece[0][1], piece[-1][2] - piece[0][2])
        by_speed += math.hypot(north, east)
    return by_position / by_speed


# ---------------------------------------------------------------- tables

UNITS = {"rad": (180 / math.pi, "deg"), "rad_s": (180 / math.pi, "deg/s"), "m_s": (1, "m/s"), "s": (1, "s"), "m": (1, "m"), "N": (1, "N"), "kN": (1, "kN")}


def in_words(key, estimate):
    """1.80 ± 0.05 m/s, angles in degrees."""
    name, factor, unit = key, 1.0, ""
    for suffix in ("rad_s", "m_s", "rad", "kN", "N", "m", "s"):
        if key.endswith("_" + suffix) and key not in ("a_H", "x_H"):
            name, (factor, unit) = key[: -len(suffix) - 1], UNITS[suffix]
            break
    if not isinstance(estimate, dict):
        return f"{name} {estimate}"
    value, error = estimate.get("value"), estimate.get("standard_error")
    if not isinstance(value, (int, float)):
        return f"{name} {value}"
    text = f"{name} {factor * value:.3g}"
    if isinstance(error, (int, float)):
        text += f" ± {factor * error:.2g}"
    return f"{text} {unit}".rstrip()


def effect_words(effect, most=None):
    parameters = sorted(effect["parameters"].items(), key=lambda p: -significance(p[1])) if most else effect["parameters"].items()
    return ", ".join(in_words(k, v) for k, v in list(parameters)[:most])


def significance(estimate):
    try:
        return abs(estimate["value"]) / estimate["standard_error"]
    except (KeyError, TypeError, ZeroDivisionError):
        return 0.0


def load(path):
    with open(path, encoding="utf-8") as file:
        return json.load(file)


def found(files):
    print("| runs | verdict | effect | probability | found | as well explained by |\n| --- | --- | --- | ---: | --- | --- |")
    for pair in files:
        label, path = pair.split("=", 1)
        d = load(path)
        verdict = d["verdict"].replace("_", " ")
        if not d["effects"]:
            print(f"| {label} | {verdict} | – | – | – | – |")
        for i, e in enumerate(d["effects"]):
            first = f"| {label} | {verdict} " if i == 0 else "| | "
            sizes = f"differs from {e['scope']} to {e['scope']}" if "scope" in e else effect_words(e, 4)
            print(f"{first}| `{e['effect']}` | {e['probability']:.2f} | {sizes} | {', '.join(e['indistinguishable_from']) or '–'} |")


def pooled_wind(runs):
    """Measured: mean of V² in both directions over runs, as speed and direction."""
    winds = [load(run.rsplit(".", 1)[0] + ".wind.json") for run in runs]
    north = sum(w["wind_speed_m_s"] ** 2 * math.cos(w["wind_from_rad"]) for w in winds) / len(winds)
    east = sum(w["wind_speed_m_s"] ** 2 * math.sin(w["wind_from_rad"]) for w in winds) / len(winds)
    return math.sqrt(math.hypot(north, east)), math.atan2(east, north) % (2 * math.pi)


def surroundings(files):
    print("| given | wind of | measured | found | speed error | direction error |\n| --- | --- | --- | --- | ---: | ---: |")
    for pair in files:
        given, path = pair.split("=", 1)
        d = load(path)
        for part in d["surroundings"]:
            speed, direction = pooled_wind(part["runs"])
            measured = f"{speed:.2f} m/s from {math.degrees(direction):.0f}°"
            label = part["scope"].replace("_", " ").removesuffix(".csv")
            V, a = part.get("wind_speed_m_s"), part.get("wind_from_rad")
            if not V or a["value"] is None:
                print(f"| {given} | {label} | {measured} | cannot tell: {part.get('cannot_tell', '')} | – | – |")
                continue
            off = math.degrees((a["value"] - direction + math.pi) % (2 * math.pi) - math.pi)
            found = f"{V['value']:.2f} ± {V['standard_error']:.2f} m/s from {math.degrees(a['value']):.0f} ± {math.degrees(a['standard_error']):.0f}°"
            if "onset_s" in part:
                found = f"gust from {part['onset_s']['value']:.0f} s on: {found}"
            print(f"| {given} | {label} | {measured} | {found} | {100 * (V['value'] / speed - 1):+.0f} % | {off:+.0f}° |")


def instruments(files):
    print("| runs | channel | error | found |\n| --- | --- | --- | --- |")
    for pair in files:
        label, path = pair.split("=", 1)
        for i in load(path)["instruments"]:
            factor, unit = (180 / math.pi, i["unit"].replace("rad", "deg")) if "rad" in i["unit"] else (1, i["unit"])
            print(f"| {label} | {i['channel']} | {i['error']} | {factor * i['value']:.3g} ± {factor * i['standard_error']:.2g} {unit} |")
            label = ""


def scales(path, channel):
    print("| run | scale | error by itself |\n| --- | ---: | ---: |")
    for run in load(path)["runs"]:
        for i in run["instruments"]:
            if i["channel"] == channel and i["error"] == "scale":
                print(f"| {run['run'].rsplit('/', 1)[-1]} | {1 + i['value']:.3f} | {i['standard_error']:.3f} |")


FOLLOWS = ["form", "form_asymmetric", "earth_fixed", "delayed", "instruments", "unexplained"]


def budget(files):
    print("| runs | force | " + " | ".join(FOLLOWS) + " | size |\n| --- | --- |" + " ---: |" * (len(FOLLOWS) + 1))
    for pair in files:
        label, path = pair.split("=", 1)
        for force, shares in load(path)["budget"].items():
            cells = [f"{100 * shares[f]:.0f} ± {100 * shares['standard_error'][f]:.0f} %" for f in FOLLOWS]
            print(f"| {label} | {force.replace('_', ' ')} | " + " | ".join(cells) + f" | {shares['size']:.2g} |")
            label = ""


def numbers(before, after, keys):
    def value(path, key):
        line = next(line for line in open(path, encoding="utf-8") if line.split("=")[0].strip() == key)
        return float(line.split("=")[1].split("#")[0])

    print("| key | file | refitted |\n| --- | ---: | ---: |")
    for key in keys:
        print(f"| `{key}` | {value(before, key):.3g} | {value(after, key):.3g} |")


def zeros(paths):
    print("| run | zero of the gyro by heading and yaw rate alone |\n| --- | ---: |")
    for path in paths:
        _, columns, rows = table_of(path)
        t, psi, r = ([float(row[columns.index(c)]) for row in rows] for c in ("time_s", "psi_rad", "r_rad_s"))
        turned_by = [0.0]
        for i in range(1, len(t)):
            turned_by.append(turned_by[-1] + 0.5 * (t[i] - t[i - 1]) * (r[i] + r[i - 1]))
        drift = [a - p for a, p in zip(turned_by, psi)]
        mean_t, mean_d = sum(t) / len(t), sum(drift) / len(t)
        slope = sum((a - mean_t) * (b - mean_d) for a, b in zip(t, drift)) / sum((a - mean_t) ** 2 for a in t)
        print(f"| {path.rsplit('/', 1)[-1]} | {math.degrees(slope):.4f} deg/s |")


def solved(A, b):
    """Least squares by the normal equations, columns scaled."""
    scale = [math.sqrt(sum(row[k] ** 2 for row in A)) for k in range(len(A[0]))]
    n = len(scale)
    M = [[sum(row[i] * row[k] for row in A) / (scale[i] * scale[k]) for k in range(n)]
         + [sum(row[i] * y for row, y in zip(A, b)) / scale[i]] for i in range(n)]
    for i in range(n):
        for k in range(i + 1, n):
            factor = M[k][i] / M[i][i]
            M[k] = [x - factor * y for x, y in zip(M[k], M[i])]
    x = [0.0] * n
    for i in reversed(range(n)):
        x[i] = (M[i][n] - sum(M[i][k] * x[k] for k in range(i + 1, n))) / M[i][i]
    return [value / s for value, s in zip(x, scale)]


def explained(A, b):
    x = solved(A, b)
    left = sum((y - sum(c * v for c, v in zip(row, x))) ** 2 for row, y in zip(A, b))
    return 1.0 - left / sum(y * y for y in b)


def roll(paths, block_s=1.0):
    print("| run | by u r | by dv/dt + u r | by both parts, each with its own lever | by dv/dt + u r and the rudder, n² delta |\n"
          "| --- | ---: | ---: | ---: | ---: |")
    for path in paths:
        _, columns, rows = table_of(path)
        samples = [{c: float(x) for c, x in zip(columns, row)} for row in rows]
        length = max(1, round(block_s * (len(samples) - 1) / (samples[-1]["time_s"] - samples[0]["time_s"])))
        blocks = [{c: sum(s[c] for s in samples[i:i + length]) / length for c in columns}
                  for i in range(0, len(samples) - length + 1, length)]
        parts, b = [], []
        for before, now, after in zip(blocks, blocks[1:], blocks[2:]):
            h = 0.5 * (after["time_s"] - before["time_s"])
            rate = {c: (after[c] - before[c]) / (2.0 * h) for c in ("phi_rad", "v_m_s")}
            b.append((after["phi_rad"] - 2.0 * now["phi_rad"] + before["phi_rad"]) / h ** 2)
            parts.append((rate["phi_rad"], now["phi_rad"], now["u_m_s"] * now["r_rad_s"], rate["v_m_s"],
                          now["rev_s"] ** 2 * now["delta_rad"]))
        of = [explained([term(*p) for p in parts], b) for term in (
            lambda p, phi, ur, dv, by_rudder: (p, phi, ur), lambda p, phi, ur, dv, by_rudder: (p, phi, ur + dv),
            lambda p, phi, ur, dv, by_rudder: (p, phi, ur, dv),
            lambda p, phi, ur, dv, by_rudder: (p, phi, ur + dv, by_rudder))]
        print(f"| {path.rsplit('/', 1)[-1]} | " + " | ".join(f"{x:.2f}" for x in of) + " |")


def delayed(samples, dead_s, lag_s):
    """The order of each sample after a dead time, then followed by a first-order lag."""
    step = samples[1]["time_s"] - samples[0]["time_s"]
    keep = math.exp(-step / lag_s) if lag_s > 0.0 else 0.0
    shift = round(dead_s / step)
    followed, out = samples[0]["delta_order_rad"], []
    for i in range(len(samples)):
        followed = keep * followed + (1.0 - keep) * samples[max(0, i - shift)]["delta_order_rad"]
        out.append(followed)
    return out


def smoothed(x, width=5):
    return [sum(x[i:i + width]) / width for i in range(len(x) - width + 1)]


def lag(paths, dead_times=(0.0, 0.5, 1.0, 2.0, 3.0), lags=(0.0, 0.5, 1.0, 2.0, 3.0, 4.0)):
    """R^2 of dr/dt by (u^2, n u, n^2) times the order, late in two ways, beside u v, u r, v|v|, r|r| and 1, all runs together. All channels are means
    over 2 s, the late order, too."""
    print("| dead time | " + " | ".join(f"lag {T:g} s" for T in lags) + " |\n| --- |" + " ---: |" * len(lags))
    runs = []
    for path in paths:
        _, columns, rows = table_of(path)
        runs.append([{c: float(x) for c, x in zip(columns, row)} for row in rows])
    for dead in dead_times:
        cells = []
        for T in lags:
            A, b = [], []
            for samples in runs:
                step = samples[1]["time_s"] - samples[0]["time_s"]
                u, v, r, n = (smoothed([s[c] for s in samples]) for c in ("ug_m_s", "vg_m_s", "r_rad_s", "rev_rpm"))
                d = smoothed(delayed(samples, dead, T))
                for i in range(1, len(r) - 1):
                    b.append((r[i + 1] - r[i - 1]) / (2.0 * step))
                    A.append((u[i] * u[i] * d[i], n[i] * u[i] * d[i], n[i] * n[i] * d[i], u[i] * v[i], u[i] * r[i], v[i] * abs(v[i]), r[i] * abs(r[i]), 1.0))
            cells.append(f"{explained(A, b):.2f}")
        print(f"| {dead:g} s | " + " | ".join(cells) + " |")


def candidates(path, most):
    print("| candidate | gain of log evidence | probability |\n| --- | ---: | ---: |")
    for c in load(path)["candidates"][:most]:
        print(f"| `{c['effect']}` | {c['log_evidence_gain']:.1f} | {c['probability']:.3f} |")


def percent(run, stage, quantity):
    value = run.get(stage, {}).get(quantity)
    return f"{100 * value:.1f}" if isinstance(value, (int, float)) else "–"


def errors(path):
    d = load(path)
    print("| run | | " + " | ".join(q.replace("_", " ") for q in SHOWN) + " |\n| --- | --- | " + " | ".join("---:" for _ in SHOWN) + " |")
    for kind, title in (("train", "used"), ("holdout", "held out")):
        for run in d["fit"][kind]:
            cells = [" → ".join(percent(run, stage, q) for stage in ("before", "refitted", "after")) for q in SHOWN]
            print(f"| {run['run']} | {title} | " + " | ".join(cells) + " |")


def picture(page, out):
    """The picture of the first screen, as the page carries it."""
    found = re.search(r'src="data:image/svg\+xml;base64,([^"]+)"', open(page, encoding="utf-8").read())
    if not found:
        sys.exit(f"{page}: no picture; is gnuplot installed?")
    with open(out, "wb") as file:
        file.write(base64.b64decode(found[1]))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    commands = parser.add_subparsers(dest="command", required=True)
    for name in ("prepare", "wind"):
        sub = commands.add_parser(name)
        sub.add_argument("file")
        if name == "prepare":
            sub.add_argument("out")
            sub.add_argument("--every", type=int, default=1)
            sub.add_argument("--drop", default="")
            sub.add_argument("--rename", default="")
            sub.add_argument("--key", action="append", default=[])
        sub.add_argument("--from", dest="begin", type=float)
        sub.add_argument("--to", dest="end", type=float)
    for name in ("found", "instruments", "surroundings", "budget", "track", "zeros", "roll", "lag"):
        commands.add_parser(name).add_argument("files", nargs="+")
    sub = commands.add_parser("numbers")
    sub.add_argument("before")
    sub.add_argument("after")
    sub.add_argument("keys", nargs="+")
    sub = commands.add_parser("scales")
    sub.add_argument("file")
    sub.add_argument("channel")
    sub = commands.add_parser("candidates")
    sub.add_argument("file")
    sub.add_argument("most", nargs="?", type=int, default=6)
    commands.add_parser("errors").add_argument("file")
    sub = commands.add_parser("picture")
    sub.add_argument("page")
    sub.add_argument("out")
    a = parser.parse_args()
    {"prepare": prepare, "wind": wind, "found": lambda x: found(x.files), "surroundings": lambda x: surroundings(x.files), "budget": lambda x: budget(x.files), "instruments": lambda x: instruments(x.files), "track": lambda x: track(x.files), "zeros": lambda x: zeros(x.files), "roll": lambda x: roll(x.files), "lag": lambda x: lag(x.files),
     "numbers": lambda x: numbers(x.before, x.after, x.keys), "scales": lambda x: scales(x.file, x.channel), "candidates": lambda x: candidates(x.file, x.most),
     "errors": lambda x: errors(x.file), "picture": lambda x: picture(x.page, x.out)}[a.command](a)


if __name__ == "__main__":
    main()
