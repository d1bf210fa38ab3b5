"""What a zigzag costs from Python, beside the same in C++: the least of many, microseconds.

    ninja -C build/dev _swayaw python_zigzag_cost
    PYTHONPATH=build/dev/python python3 python/bench/zigzag_cost.py build/dev/python/python_zigzag_cost
"""

import math
import subprocess
import sys
import time

import swayaw


def least(sampled: bool) -> float:
    ship, angle, best = swayaw.published_ship("kvlcc2"), math.radians(10), math.inf
    for _ in range(2000):
        begin = time.perf_counter()
        swayaw.zigzag(ship, angle, angle, sampled=sampled)
        best = min(best, time.perf_counter() - begin)
    return 1e6 * best


def main() -> None:
    for how, sampled in (("bare", False), ("sampled", True)):
        rounds = range(5)
        cpp = min(float(subprocess.run([sys.argv[1], how], check=True, capture_output=True, text=True).stdout) for _ in rounds)
        python = min(least(sampled) for _ in rounds)
        print(f"zigzag 10/10 of KVLCC2, {how}: C++ {cpp:.1f} µs, Python {python:.1f} µs, over C++ {python - cpp:.1f} µs")


if __name__ == "__main__":
    main()
