"""Plain ``pytest`` in two pools at once: what computes, and what waits for devices.

A worker of a pool collects only the files of its pool. Tests that compute yield to those that
wait, which need a core for moments, but then at once.
"""

import json
import os
import shutil
import tempfile
from collections.abc import Sequence
from itertools import groupby
from pathlib import Path

import pytest
from xdist.workermanage import WorkerController

from tests.running.marks import Cost, Pool, is_soak_file, pool_of_test, pools_of_file, test_files
from tests.running.scheduler import PoolScheduler

WAITING_WORKERS = 6
YIELDED = 4
"""Steps of priority by which tests that compute yield to those that wait."""
COSTLY = ("e2e", "api", "bench", "batch", "fleet")
"""Folders of tests that wait and also take much of a core: a browser, a whole station."""


def pytest_xdist_auto_num_workers(config: pytest.Config) -> int:
    """As many workers as the named tests are worth; none, this process itself, for one file."""
    return len(planned_workers(config)) if len(_named_files(config)) > 1 else 0


def planned_workers(config: pytest.Config, count: int | None = None) -> list[frozenset[Pool]]:
    """The pools of each worker, for so many workers; None: for as many as the tests are worth."""
    files = [pools_of_file(path) for path in _named_files(config)]
    cores = os.cpu_count() or 1
    computing = min(cores, sum(Pool.COMPUTING in one for one in files))
    waiting = min(WAITING_WORKERS, sum(Pool.WAITING in one for one in files))
    if count is None:
        count = computing + waiting
    if count == 1:
        return [frozenset(Pool)]
    if computing and waiting:
        computing = min(computing, count // 2)
    elif computing:
        computing = count
    of_each = ((Pool.COMPUTING, computing), (Pool.WAITING, count - computing))
    return [frozenset({pool}) for pool, number in of_each for _ in range(number)]


def _named_files(config: pytest.Config, folders: bool = True) -> list[Path]:
    """The test files that the command names, with those in the folders that it names."""
    names = (argument.partition("::")[0] for argument in config.args)
    places = [Path(os.path.abspath(config.invocation_params.dir / name)) for name in names]
    return list(dict.fromkeys(test_files(one for one in places if folders or one.is_file())))


class Controller:
    """What the process does that starts the workers."""

    def __init__(self, config: pytest.Config) -> None:
        self.folder = Path(tempfile.mkdtemp(prefix="pytest-pools-"))
        self.vacant = planned_workers(config, len(config.getvalue("tx")))
        self.pools: dict[WorkerController, frozenset[Pool]] = {}
        self.scheduler = PoolScheduler(len(self.vacant))

    def pytest_configure_node(self, node: WorkerController) -> None:
        self.pools[node] = pools = self.vacant.pop(0)
        node.workerinput["pools"] = [str(pool) for pool in pools]
        node.workerinput["units"] = str(self.folder / f"{node.gateway.id}.json")

    def pytest_testnodedown(self, node: WorkerController, error: object) -> None:
        if error:
            self.vacant.append(self.pools[node])

    def pytest_xdist_make_scheduler(self) -> PoolScheduler:
        return self.scheduler

    @pytest.hookimpl(wrapper=True)
    def pytest_runtestloop(self, session: pytest.Session) -> object:
        done = yield
        # pytest-xdist counts those of the worker that was last to report them
        session.testscollected = self.scheduler.collected
        return done

    def pytest_unconfigure(self) -> None:
        shutil.rmtree(self.folder, ignore_errors=True)


class Worker:
    """What a worker of a pool does, or a process that runs all tests itself."""

    def __init__(self, config: pytest.Config) -> None:
        given = getattr(config, "workerinput", {})
        self.pools = frozenset(Pool(one) for one in given.get("pools", Pool))
        self.units = Path(given["units"]) if "units" in given else None
        self.config = config
        self.named = frozenset(_named_files(config, folders=False))
        self.soaks = _asks_for_soak(config)
        if self.pools == {Pool.COMPUTING}:
            os.nice(YIELDED)

    def pytest_ignore_collect(self, collection_path: Path) -> bool | None:
        """Leaves files alone that have no test of these pools."""
        if collection_path.suffix != ".py" or not collection_path.name.startswith("test_"):
            return None
        if not self.pools & pools_of_file(collection_path):
            return True
        named = self.soaks or collection_path in self.named
        return True if not named and is_soak_file(collection_path) else None

    @pytest.hookimpl(tryfirst=True)
    def pytest_itemcollected(self, item: pytest.Item) -> None:
        if not any(item.get_closest_marker(cost) for cost in Cost):
            item.add_marker("quick")

    @pytest.hookimpl(trylast=True)
    def pytest_collection_modifyitems(self, items: list[pytest.Item]) -> None:
        items[:] = [item for item in items if pool_of_test(item) in self.pools]
        if not self.soaks:
            soak = [
                item
                for item in items
                if item.get_closest_marker(Cost.SOAK) and item.path not in self.named
            ]
            if soak:
                self.config.hook.pytest_deselected(items=soak)
                items[:] = [item for item in items if item not in soak]
        if self.units is not None:
            units = ordered_units(items)
            self.units.write_text(json.dumps([[item.nodeid for item in unit] for unit in units]))


def _asks_for_soak(config: pytest.Config) -> bool:
    """Whether tests are chosen by their marks or names: who asks for a test gets it."""
    return bool(config.option.markexpr or config.option.keyword)


def ordered_units(items: Sequence[pytest.Item]) -> list[list[pytest.Item]]:
    """Tests that one worker runs one after another, the costly first."""
    units: list[list[pytest.Item]] = []
    for _, group in groupby(items, lambda item: item.path):
        tests = list(group)
        together = pool_of_test(tests[0]) == Pool.COMPUTING or any(map(_shares, tests))
        units += [tests] if together else [[test] for test in tests]
    return sorted(units, key=_rank)


def _shares(item: pytest.Item) -> bool:
    """Whether a test uses what was set up for several tests of its file."""
    found = getattr(item, "_fixtureinfo", None)
    definitions = found.name2fixturedefs.values() if found else ()
    return any(one[-1].scope in ("module", "class") for one in definitions if one)


def _rank(unit: list[pytest.Item]) -> int:
    first = unit[0]
    if pool_of_test(first) == Pool.COMPUTING:
        return 0 if first.get_closest_marker(Cost.SLOW) else 1
    folder = first.path.parent.name
    return COSTLY.index(folder) if folder in COSTLY else len(COSTLY)
