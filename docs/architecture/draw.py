#!/usr/bin/env python3
"""Draws the floors of the house with their sizes and the includes between them, from the sources.

usage: docs/architecture/draw.py [OUT.svg]     (run in the top folder of the project; needs only Python)
"""
import collections, os, re, sys

FLOORS = ["core", "linear", "nonlinear", "identification", "mismatch", "app"]
SAYS = {
    "core": "what is a sample? which unit?",
    "linear": "what do these derivatives mean for steering?",
    "nonlinear": "what force acts here, and from which part?",
    "identification": "which parameters explain this recording?",
    "mismatch": "what did the model leave out?",
    "app": "program and pages",
}
INCLUDE = re.compile(r'#include "swayaw/(\w+)/')


def sources(floor):
    for folder, _, files in os.walk(floor):
        for name in files:
            if name.endswith((".hpp", ".cpp")):
                yield os.path.join(folder, name)


def read():
    lines, includes, rooms = collections.Counter(), collections.Counter(), collections.defaultdict(set)
    for floor in FLOORS:
        for path in sources(floor):
            text = open(path, encoding="utf-8").read()
            lines[floor] += text.count("\n")
            for other in INCLUDE.findall(text):
                if other in FLOORS and other != floor:
                    includes[floor, other] += 1
            parts = path.split(os.sep)
            if "src" in parts and parts.index("src") + 2 < len(parts):
                rooms[floor].add(parts[parts.index("src") + 1])
            if "include" in parts and parts.index("include") + 4 < len(parts):
                rooms[floor].add(parts[parts.index("include") + 3])
    return lines, includes, rooms


def drawn(lines, includes, rooms):
    height, width, left, top = 64, 460, 210, 20
    place = {f: top + (len(FLOORS) - 1 - i) * (height + 16) for i, f in enumerate(FLOORS)}
    out = [f'<svg xmlns="http://www.w3.org/2000/svg" width="{left + width + 20}" height="{top + len(FLOORS) * (height + 16)}" font-family="sans-serif" font-size="13">']
    for floor in FLOORS:
        y = place[floor]
        out.append(f'<rect x="{left}" y="{y}" width="{width}" height="{height}" rx="6" fill="#eef3f8" stroke="#456"/>')
        out.append(f'<text x="{left + 12}" y="{y + 20}" font-weight="bold">{floor}</text>')
        out.append(f'<text x="{left + width - 12}" y="{y + 20}" text-anchor="end">{lines[floor]:,} lines</text>')
        out.append(f'<text x="{left + 12}" y="{y + 38}" fill="#234">{SAYS[floor]}</text>')
        out.append(f'<text x="{left + 12}" y="{y + 55}" fill="#678">{", ".join(sorted(rooms[floor]))}</text>')
    for (a, b), count in sorted(includes.items()):
        steps = FLOORS.index(a) - FLOORS.index(b)
        x = left - 14 - 30 * (abs(steps) - 1)
        y0, y1 = place[a] + height / 2, place[b] + height / 2
        colour = "#456" if steps > 0 else "#c00"
        out.append(f'<path d="M{left},{y0 + 4 * steps} H{x} V{y1 - 4 * steps} H{left}" fill="none" stroke="{colour}" stroke-width="{1 + count / 60:.1f}" opacity="0.6"/>')
    out.append("</svg>")
    return "\n".join(out) + "\n"


if __name__ == "__main__":
    target = sys.argv[1] if len(sys.argv) > 1 else "docs/architecture/house.svg"
    lines, includes, rooms = read()
    upward = [(a, b) for a, b in includes if FLOORS.index(a) < FLOORS.index(b)]
    if upward:
        sys.exit(f"includes that go up: {upward}")
    open(target, "w", encoding="utf-8").write(drawn(lines, includes, rooms))
