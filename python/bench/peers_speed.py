"""The same problems by what users of Python have and by swayaw, side by side: accuracy first, then time.

    ninja -C build/dev _swayaw
    PYTHONPATH=build/dev/python python3 python/bench/peers_speed.py [--write bench/README.md] [--seconds 3] [--check]

--check looks at the accuracy of both and times nothing. scipy is needed; numba, statsmodels and python-control have
rows of their own, which are left out, with a word, where they are not installed. The problems: peers/problems.py.
"""

import argparse
import importlib
import math
import pathlib
import platform
import re
import sys
import time

from peers.problems import Problem, all_problems, installed


def checked(problem: Problem) -> tuple:
    """Errors of both; ends the program where one is too large."""
    errors = [float(problem.error(way())) for way in (problem.by_peer, problem.by_swayaw)]
    for who, error in zip((problem.peer, problem.call), errors):
        if not error <= problem.limit:
            sys.exit(f"{problem.name}, {who}: error {error:.2g} {problem.unit}, more than {problem.limit:g}")
    return errors


def least_times(problem: Problem, seconds: float) -> list:
    """Least processor time of each, the two taking turns."""
    clock = time.process_time  # other work on the machine counts little, and all threads count
    least = [math.inf, math.inf]
    end = clock() + seconds
    while clock() < end:
        for i, way in enumerate((problem.by_peer, problem.by_swayaw)):
            turn_ends = clock() + 0.05 * seconds
            while True:
                begin = clock()
                way()
                now = clock()
                least[i] = min(least[i], now - begin)
                if now > turn_ends:
                    break
    return least


def told(seconds: float) -> str:
    return f"{1e3 * seconds:.3g} ms" if seconds >= 1e-3 else f"{1e6 * seconds:.3g} µs"


def row(problem: Problem, errors: list, least: list) -> str:
    peer, own = (f"{error:.1g} {problem.unit}" for error in errors)
    ratio = least[0] / least[1]
    over = f"{ratio:.2g}" if ratio < 10.0 else f"{round(ratio, 1 - int(math.log10(ratio))):.0f}"
    cells = [problem.name, problem.peer, told(least[0]), peer, problem.call, told(least[1]), own, over]
    return f"| {' | '.join(cells)} |"


def table(problems: list, seconds: float) -> str:
    lines = [
        "| work | in Python | least time | error | in swayaw | least time | error | Python over swayaw |",
        "| --- | --- | ---: | ---: | --- | ---: | ---: | ---: |",
    ]
    faster = []
    for problem in problems:
        errors, least = checked(problem), least_times(problem, seconds)
        lines.append(row(problem, errors, least))
        if least[0] < least[1]:
            faster.append(f"{problem.peer} ({problem.name})")
        print(lines[-1], file=sys.stderr)
    lines += ["", f"Python is the faster one in: {'; '.join(faster) or 'none of these'}.", ""]
    lines.append(f"{processor()}; {versions()}.")
    return "\n".join(lines) + "\n"


def versions() -> str:
    names = [name for name in ("numpy", "scipy", "numba", "statsmodels", "control") if installed(name)]
    packages = [f"{name} {importlib.import_module(name).__version__}" for name in names]
    return ", ".join([f"Python {platform.python_version()}", *packages])


def processor() -> str:
    try:
        found = re.search(r"model name\s*:\s*(.*)", pathlib.Path("/proc/cpuinfo").read_text())
    except OSError:
        found = None
    return found.group(1) if found else platform.machine()


def write_between_markers(file: pathlib.Path, text: str) -> None:
    """Replaces what stands between <!-- table: peers --> and <!-- end -->."""
    page = file.read_text(encoding="utf-8")
    between = re.compile(r"(<!-- table: peers -->\n).*?(<!-- end -->)", flags=re.S)
    changed, count = between.subn(lambda found: found[1] + text + found[2], page)
    if count != 1:
        sys.exit(f"{file}: no line <!-- table: peers -->, or no <!-- end --> after it")
    file.write_text(changed, encoding="utf-8")


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--write", type=pathlib.Path, metavar="PAGE", help="where the table goes, between its markers")
    parser.add_argument("--seconds", type=float, default=3.0, help="for each row (3)")
    parser.add_argument("--check", action="store_true", help="accuracy only, no times")
    options = parser.parse_args()
    if options.seconds <= 0.0:
        parser.error(f"--seconds must be positive, got {options.seconds:g}")
    if options.write and not options.write.is_file():
        parser.error(f"{options.write}: no such file")
    problems = []
    for problem in all_problems():
        if installed(problem.needs):
            problems.append(problem)
        else:
            print(f"{problem.needs} is not installed: no row for {problem.peer}", file=sys.stderr)
    if options.check:
        for problem in problems:
            peer, own = checked(problem)
            print(f"{problem.name}, {problem.peer}: error {peer:.1g}, of swayaw {own:.1g} {problem.unit}")
        return
    text = table(problems, options.seconds)
    if options.write:
        write_between_markers(options.write, text)
    else:
        print(text, end="")


if __name__ == "__main__":
    main()
