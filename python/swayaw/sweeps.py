"""Sweeps of many ships over threads, or over the workers of a Dask cluster (docs/sweep.md)."""

from __future__ import annotations

import concurrent.futures
import functools
import os
from typing import Callable, Iterable, List, Optional, Union

from . import _swayaw

#: blocks of one task of a cluster: a task costs its scheduler about a millisecond
BLOCKS_OF_A_TASK = 32


@functools.lru_cache(maxsize=4)
def _work(plan: str, changed: float) -> _swayaw.SweepWork:
    """The work of a plan, laid out once in a process; `changed` is the time of its last change."""
    return _swayaw.SweepWork(plan)


def _blocks(plan: str, places: List[int]) -> List[_swayaw.SweepBlock]:
    """What a worker does: plan and ships are read where it runs."""
    work = _work(plan, os.stat(plan).st_mtime)
    return [work.block(place) for place in places]


def _tasks(rest: List[int]) -> Iterable[List[int]]:
    return (rest[i : i + BLOCKS_OF_A_TASK] for i in range(0, len(rest), BLOCKS_OF_A_TASK))


def _by_threads(plan: str, rest: List[int]) -> Iterable[List[_swayaw.SweepBlock]]:
    with concurrent.futures.ThreadPoolExecutor() as pool:
        waiting = [pool.submit(_blocks, plan, places) for places in _tasks(rest)]
        for task in concurrent.futures.as_completed(waiting):
            yield task.result()


def _by_cluster(client, plan: str, rest: List[int]) -> Iterable[List[_swayaw.SweepBlock]]:
    from dask.distributed import as_completed

    waiting = client.map(functools.partial(_blocks, plan), list(_tasks(rest)), pure=False)
    for task, blocks in as_completed(waiting, with_results=True):
        task.release()
        yield blocks


def sweep(
    plan: Union[str, os.PathLike],
    out: Union[str, os.PathLike],
    client=None,
    progress: Optional[Callable[[int, int], object]] = None,
) -> _swayaw.SweepStore:
    """Works on what is not there yet of a sweep, and returns its results.

    plan: file of the plan (TOML), which all workers can read, the ship files beside it too. out: folder of the results,
    the same as of `swayaw sweep --out`: program and module go on where the other was, and end with the same numbers.
    client: of dask.distributed; without one all cores of this machine work. progress: is told how many blocks are there,
    of how many, after each task. Raises FileError for a mistake in the plan, Refusal for recordings, which the program
    works on, and for a folder with other results.
    """
    plan = os.path.abspath(plan)
    work = _swayaw.SweepWork(plan)
    store = _swayaw.SweepStore(out, work)
    rest = store.rest
    done = work.blocks - len(rest)
    for blocks in _by_threads(plan, rest) if client is None else _by_cluster(client, plan, rest):
        store.write(blocks)
        done += len(blocks)
        if progress is not None:
            progress(done, work.blocks)
    return store
