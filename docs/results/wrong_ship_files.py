"""The same cases with ship files that are wrong: wrong_ship_files.py CASES FOLDER DEVIATION SEED

Every coefficient of hull, added mass, propeller and rudder is off by a normal deviate, relative to its value; lists by one deviate. Recordings and labels stay.
"""
import pathlib
import random
import re
import sys

cases, folder, deviation, seed = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]), float(sys.argv[3]), int(sys.argv[4])
wrong_tables = {"added_mass", "hull", "propeller", "rudder"}
right_numbers = {"diameter_m", "x_prime", "area_m2", "height_m", "rate_deg_s", "max_angle_deg"}  # measured, not fitted

for number, case in enumerate(sorted(cases.iterdir())):
    chance = random.Random(1000 * seed + number)
    home = folder / case.name
    home.mkdir(parents=True, exist_ok=True)
    for part in case.iterdir():
        if part.name != "ship.toml" and not (home / part.name).exists():
            (home / part.name).symlink_to(part)
    table, lines = "", []
    for line in (case / "ship.toml").read_text().splitlines():
        key, _, value = line.partition(" = ")
        if line.startswith("["):
            table = line.strip("[]")
        elif table in wrong_tables and value and key not in right_numbers:
            factor = 1.0 + deviation * chance.gauss(0.0, 1.0)
            line = f"{key} = " + re.sub(r"-?\d[\d.e+-]*", lambda m: f"{float(m[0]) * factor:.8g}", value)
        lines.append(line)
    (home / "ship.toml").write_text("\n".join(lines) + "\n")
