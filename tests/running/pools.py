"""Plain ``pytest`` in two pools at once: what computes, and what waits for devices.

A worker of a pool collects only the files of its pool. Tests that compute yield to those that
wait, which need a core for moments, but then at once.
"""

import json
import math
import os
import shutil
import tempfile
import time
import timeit
from collections.abc import Sequence
from dataclasses import asdict
from functools import cache
from itertools import groupby
from pathlib import Path

import pytest
from xdist.workermanage import WorkerController

from tests.running.marks import Cost, Pool, pool_of_test, pools_of_file, read_marks, test_files
from tests.running.scheduler import PoolScheduler, Unit

WAITING_WORKERS = 6
"""On a quick machine; on a slow one, stations and browsers would starve each other."""
YIELDED = 15
"""Steps of priority by which tests that compute yield to those that wait."""
COMPUTING_S = 3600
"""For a test that yields: how long it takes says little of it."""
COSTLY = ("e2e", "api", "station", "bench", "batch", "fleet")
"""Folders of tests that wait and also take much of a core: a browser, a whole station."""
ALONE = "xdist_group"
"""The mark of tests that cannot run beside each other."""
QUICK_S = 0.004
"""In which a quick machine adds half a million numbers."""
SLOW = 0.7
"""Of the quickness of a quick machine; below it, one browser runs at once. Each has a session of
its own, which Linux gives as much of the processor as all stations together."""
BROWSER = "e2e"
CORES = os.cpu_count() or 1


def add_within(parser: pytest.Parser) -> None:
    """The option for a run that has an end."""
    parser.addoption(
        "--within",
        type=float,
        metavar="SECONDS",
        help="begin no further test after this time, and say which were left out",
    )


def pytest_xdist_auto_num_workers(config: pytest.Config) -> int:
    """As many workers as the chosen tests are worth; none, this process itself, for one file."""
    choice = Choice(config)
    return len(planned_workers(choice.files)) if len(choice.files) > 1 else 0


class Choice:
    """The tests that a command asks for. Soak tests must be asked for: by a mark, a part of the
    name, or the name of their file."""

    def __init__(self, config: pytest.Config) -> None:
        names = (argument.partition("::")[0] for argument in config.args)
        places = [Path(os.path.abspath(config.invocation_params.dir / name)) for name in names]
        self.named = frozenset(one for one in places if one.is_file())
        self.marks: str = config.option.markexpr
        self.asks = bool(self.marks or config.option.keyword)
        self.files = [path for path in dict.fromkeys(test_files(places)) if self.may_have(path)]
        """All files that may have one of the tests."""

    def may_have(self, path: Path) -> bool:
        """Whether some test of a file can be meant, by the marks in its text."""
        marks = read_marks(path)
        match self.marks:
            case "quick":
                return not marks.of_all
            case Cost.SLOW | Cost.DEVICE | Cost.SOAK:
                return self.marks in marks.of_some
        return self.asks or path in self.named or Cost.SOAK not in marks.of_all

    def has(self, item: pytest.Item) -> bool:
        """Whether a test is meant, as far as soak tests are concerned."""
        return self.asks or item.path in self.named or not item.get_closest_marker(Cost.SOAK)


def planned_workers(files: Sequence[Path], count: int | None = None) -> list[frozenset[Pool]]:
    """The pools of each worker, for so many workers; None: for as many as the files are worth."""
    pools = [pools_of_file(path) for path in files]
    computing = min(CORES, sum(Pool.COMPUTING in one for one in pools))
    most_waiting = min(max(round(WAITING_WORKERS * quickness()), CORES + 2), WAITING_WORKERS)
    waiting = min(most_waiting, sum(Pool.WAITING in one for one in pools))
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


@cache
def quickness() -> float:
    """Of one core of this machine, beside one of a quick machine."""
    return QUICK_S / min(timeit.repeat("sum(range(500_000))", timer=time.process_time, number=1))


def count_costly_at_once() -> int:
    """How many tests that wait and take much of a core run at once."""
    return min(max(int(WAITING_WORKERS * quickness()), CORES), WAITING_WORKERS)


class Controller:
    """What the process does that starts the workers."""

    def __init__(self, config: pytest.Config) -> None:
        self.folder = Path(tempfile.mkdtemp(prefix="pytest-pools-"))
        self.vacant = planned_workers(Choice(config).files, len(config.getvalue("tx")))
        self.pools: dict[WorkerController, frozenset[Pool]] = {}
        within_s: float | None = config.getoption("within")
        ends_s = math.inf if within_s is None else time.monotonic() + within_s
        self.scheduler = PoolScheduler(len(self.vacant), count_costly_at_once(), ends_s)

    def pytest_configure_node(self, node: WorkerController) -> None:
        self.pools[node] = pools = self.vacant.pop(0)
        node.workerinput["pools"] = [str(pool) for pool in pools]
        node.workerinput["one_browser"] = quickness() < SLOW
        node.workerinput["units"] = str(self.folder / f"{node.gateway.id}.json")

    def pytest_testnodedown(self, node: WorkerController, error: object) -> None:
        if error:
            self.vacant.append(self.pools[node])

    def pytest_xdist_make_scheduler(self) -> PoolScheduler:
        return self.scheduler

    def pytest_sessionstart(self, session: pytest.Session) -> None:
        self.scheduler.session = session

    def pytest_terminal_summary(self, terminalreporter: pytest.TerminalReporter) -> None:
        if left := self.scheduler.left:
            files = sorted({test.partition("::")[0] for test in left})
            line = f"{len(left)} tests were not begun in time, of {', '.join(files)}"
            terminalreporter.write_line(line, yellow=True)

    def pytest_unconfigure(self) -> None:
        shutil.rmtree(self.folder, ignore_errors=True)


class Worker:
    """What a worker of a pool does, or a process that runs all tests itself."""

    def __init__(self, config: pytest.Config) -> None:
        given = getattr(config, "workerinput", {})
        self.pools = frozenset(Pool(one) for one in given.get("pools", Pool))
        self.units = Path(given["units"]) if "units" in given else None
        self.one_browser = bool(given.get("one_browser"))
        self.config = config
        self.choice = Choice(config)
        if self.pools == {Pool.COMPUTING}:
            os.nice(YIELDED)

    def pytest_ignore_collect(self, collection_path: Path) -> bool | None:
        """Leaves files alone that have no test of these pools."""
        if collection_path.suffix != ".py" or not collection_path.name.startswith("test_"):
            return None
        if self.pools & pools_of_file(collection_path) and self.choice.may_have(collection_path):
            return None
        return True

    @pytest.hookimpl(tryfirst=True)
    def pytest_itemcollected(self, item: pytest.Item) -> None:
        if not any(item.get_closest_marker(cost) for cost in Cost):
            item.add_marker("quick")

    @pytest.hookimpl(trylast=True)
    def pytest_collection_modifyitems(self, items: list[pytest.Item]) -> None:
        of_pools = [item for item in items if pool_of_test(item) in self.pools]
        items[:] = [item for item in of_pools if self.choice.has(item)]
        if left_out := [item for item in of_pools if not self.choice.has(item)]:
            self.config.hook.pytest_deselected(items=left_out)
        if self.units is not None:
            self._mark(items)
            units = ordered_units(items)
            described = [
                Unit(_rank(unit) < len(COSTLY), [one.nodeid for one in unit]) for unit in units
            ]
            self.units.write_text(json.dumps([asdict(one) for one in described]))

    def _mark(self, items: Sequence[pytest.Item]) -> None:
        """What the pools ask of tests beside their own marks."""
        for item in items:
            if self.one_browser and item.path.parent.name == BROWSER:
                item.add_marker(pytest.mark.xdist_group(BROWSER))
            yields = pool_of_test(item) == Pool.COMPUTING
            if yields and not item.get_closest_marker("timeout"):
                item.add_marker(pytest.mark.timeout(COMPUTING_S))


def ordered_units(items: Sequence[pytest.Item]) -> list[list[pytest.Item]]:
    """Tests that one worker runs one after another, the costly first.

    These are single tests that wait, the files of those that share something or compute, and all
    tests with one name of the mark ``ALONE``.
    """
    units: dict[str, list[pytest.Item]] = {}
    for path, group in groupby(items, lambda item: item.path):
        tests = list(group)
        together = pool_of_test(tests[0]) == Pool.COMPUTING or any(map(_shares, tests))
        for test in tests:
            grouped = test.get_closest_marker(ALONE)
            name = str(grouped.args[0]) if grouped else str(path) if together else test.nodeid
            units.setdefault(name, []).append(test)
    return sorted(units.values(), key=_rank)


def _shares(item: pytest.Item) -> bool:
    """Whether a test uses what was set up for several tests of its file."""
    found = getattr(item, "_fixtureinfo", None)
    definitions = found.name2fixturedefs.values() if found else ()
    return any(one[-1].scope in ("module", "class") for one in definitions if one)


def _rank(unit: list[pytest.Item]) -> int:
    first = unit[0]
    if first.get_closest_marker(ALONE):
        return -1
    if pool_of_test(first) == Pool.COMPUTING:
        return 0 if first.get_closest_marker(Cost.SLOW) else 1
    folder = first.path.parent.name
    return COSTLY.index(folder) if folder in COSTLY else len(COSTLY)
