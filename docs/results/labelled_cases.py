"""Tables of labelled cases from their scores: labelled_cases.py FOLDER SCORES.json [WRONG_SCORES.json]

The second scores are those of the same cases with ship files that are wrong.
"""
import json
import pathlib
import statistics
import sys

folder, rows = pathlib.Path(sys.argv[1]), json.load(open(sys.argv[2]))


def level(row):
    return row["truth"][0].split(":")[1] if ":" in row["truth"][0] else "none"


def share(some, key):
    return f"{sum(bool(r[key]) for r in some)} of {len(some)}" if some else "-"


def median(values):
    return f"{statistics.median(values):.3g}" if values else "-"


def write(name, head, lines):
    text = ["| " + " | ".join(head) + " |", "| " + " | ".join("---" for _ in head) + " |"]
    text += ["| " + " | ".join(str(x) for x in line) + " |" for line in lines]
    (folder / f"{name}.md").write_text("\n".join(text) + "\n")


def scores(name, rows):
    groups = {
        "one effect, strong": [r for r in rows if level(r) == "strong" and len(r["truth"]) == 1 and not r["truth"][0].startswith("unknown")],
        "one effect, moderate": [r for r in rows if level(r) == "moderate" and len(r["truth"]) == 1 and not r["truth"][0].startswith("unknown")],
        "two effects": [r for r in rows if len(r["truth"]) > 1],
        "unknown": [r for r in rows if r["truth"][0].startswith("unknown")],
        "nothing": [r for r in rows if r["truth"] == ["none"]],
    }
    lines = []
    for group, some in groups.items():
        gains = [[r[k] for r in some if k in r] for k in ("gain_yaw_rate", "gain_heading")]
        lines.append([group, share(some, "top1"), share(some, "top3"), *map(median, gains), median([r["seconds"] for r in some])])
    write(name, ["cases", "first", "among three", "gain in yaw rate", "gain in heading", "seconds"], lines)


scores("scores", rows)
for path in sys.argv[3:]:
    wrong = json.load(open(path))
    scores("wrong", wrong)
    write("missed", ["case", "hidden", "verdict", "found"],
          [[r["case"], ", ".join(t.replace(":", " ") for t in r["truth"]), r["verdict"], ", ".join(r["got"]) or "-"] for r in wrong if not r["top1"]])

write("cases", ["case", "hidden", "verdict", "found", "errors of its numbers", "first"],
      [[r["case"], ", ".join(t.replace(":", " ") for t in r["truth"]), r["verdict"], ", ".join(r["got"]) or "-",
        ", ".join(f"{k} {v:+.3g}" for k, v in r["errors"].items()) or "-", "yes" if r["top1"] else "**no**"] for r in rows])

confused = {}
for r in rows:
    names = [t.split(":")[0] for t in r["truth"]]
    for got in r["got"]:
        if got not in names:
            confused.setdefault((", ".join(names), got), []).append(r["case"])
write("confusions", ["hidden", "also or instead named", "cases"], [[a, b, ", ".join(c)] for (a, b), c in sorted(confused.items())])
