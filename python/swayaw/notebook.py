"""What long work shows in a notebook while it goes on: one line that changes."""

from __future__ import annotations

import sys
import time
from typing import Any, Optional


def _words(work: str, told: tuple) -> str:
    """What `diagnose`, `fit_trajectories` and `tune` tell, in one line."""
    if work == "fit_trajectories":
        iteration, log_likelihood, change, _ = told
        return f"iteration {iteration}, log likelihood {log_likelihood:.6g}, change {change:.1e}"
    if work == "tune":
        count, error = told
        return (
            f"{count.turns} turning circles, {count.zigzags} zigzags, "
            f"squared errors {error.turns:.4f} and {error.zigzags:.4f}"
        )
    return " ".join(map(str, told))


class Line:
    """A line of a notebook, changed at most five times in a second."""

    def __init__(self, work: str, display):
        self.work, self.begin, self.last = work, time.monotonic(), -1.0
        self.handle = display(self._bundle("…"), raw=True, display_id=True)

    def _bundle(self, words: str) -> dict:
        return {"text/plain": f"{self.work}, {time.monotonic() - self.begin:.0f} s: {words}"}

    def __call__(self, *told: Any) -> None:
        now = time.monotonic()
        if now - self.last >= 0.2:
            self.last = now
            self.handle.update(self._bundle(_words(self.work, told)), raw=True)

    def end(self) -> None:
        self.handle.update(self._bundle("done"), raw=True)


def line(work: str) -> Optional[Line]:
    """A line for a work of that name; None outside a notebook."""
    ipython = sys.modules.get("IPython")  # a notebook has it; nobody else need load it
    shell = ipython.get_ipython() if ipython else None
    if shell is None or not hasattr(shell, "kernel"):
        return None
    from IPython.display import display

    return Line(work, display)
