"""Gives tests to the workers of two pools: one a core that compute, and more that wait.

A unit of work is a test, or all tests of a file where they share what one of them set up.
"""

import json
import time
from collections import deque
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import pytest
from xdist.workermanage import WorkerController

from tests.running.marks import Pool

AHEAD = 2
"""Tests that a worker needs to go on: it begins one when it knows the next."""


@dataclass(frozen=True)
class Unit:
    """Tests that one worker runs one after another, and whether they take much of a core."""

    costly: bool
    tests: list[str]


class PoolScheduler:
    """Runs each test once, in its pool; implements the interface of pytest-xdist's schedulers.

    Workers of a pool have the same tests; of those that wait, the first take the costly tests from
    the front of the queue, and the others the light ones from its end, and no costly ones.

    Args:
        expected: how many workers there are.
        costly_at_once: how many of those that wait may take costly tests.
        ends_s: no test is begun after it (``time.monotonic``); ``left`` has those left out.
    """

    def __init__(self, expected: int, costly_at_once: int, ends_s: float) -> None:
        self.session: pytest.Session | None = None
        self.left: list[str] = []
        self._expected, self._costly_at_once, self._ends_s = expected, costly_at_once, ends_s
        self._ids: dict[WorkerController, list[str]] = {}
        self._pending: dict[WorkerController, list[int]] = {}
        self._queues: dict[frozenset[Pool], deque[Unit]] = {}
        self._front: dict[frozenset[Pool], list[WorkerController]] = {}

    @property
    def nodes(self) -> list[WorkerController]:
        return list(self._pending)

    @property
    def collected(self) -> int:
        """How many tests all pools have."""
        return sum({pools_of_worker(node): len(ids) for node, ids in self._ids.items()}.values())

    @property
    def collection_is_completed(self) -> bool:
        """Each worker begins as soon as it knows its tests."""
        return bool(self._ids)

    @property
    def tests_finished(self) -> bool:
        return len(self._ids) >= self._expected and not (
            any(self._queues.values())
            or any(len(pending) >= AHEAD for pending in self._pending.values())
        )

    @property
    def has_pending(self) -> bool:
        return any(self._queues.values()) or any(self._pending.values())

    def add_node(self, node: WorkerController) -> None:
        self._pending[node] = []

    def add_node_collection(self, node: WorkerController, collection: Sequence[str]) -> None:
        pools = pools_of_worker(node)
        self._ids[node] = list(collection)
        if pools not in self._queues:
            written = units_file(node)  # none if a file that was asked for is not there
            units = json.loads(written.read_text("utf-8")) if written.exists() else []
            self._queues[pools] = deque(Unit(**unit) for unit in units)
        front = self._front.setdefault(pools, [])
        if Pool.COMPUTING in pools or len(front) < self._costly_at_once:
            front.append(node)

    def schedule(self) -> None:
        if self.session is not None:
            # pytest-xdist has counted those of the worker that was last to report them
            self.session.testscollected = self.collected
        for node in self._ids:
            if node in self._pending:
                self._give(node)

    def mark_test_complete(
        self, node: WorkerController, item_index: int, duration: float = 0
    ) -> None:
        self._pending[node].remove(item_index)
        self._give(node)

    def remove_node(self, node: WorkerController) -> str | None:
        """Takes away a worker that ended; what it had not begun is given to others. Returns the
        test at which it ended, if not in order."""
        pending = self._pending.pop(node)
        if not pending:
            return None
        ids, pools = self._ids.pop(node), pools_of_worker(node)
        if node in self._front[pools]:
            self._front[pools].remove(node)  # another takes its place
        ended_at, *rest = (ids[index] for index in pending)
        if rest:
            self._queues[pools].appendleft(Unit(True, rest))
        self.schedule()
        return ended_at

    def mark_test_pending(self, item: str) -> None:
        raise NotImplementedError

    def remove_pending_tests_from_node(
        self, node: WorkerController, indices: Sequence[int]
    ) -> None:
        raise NotImplementedError

    def _give(self, node: WorkerController) -> None:
        while len(self._pending[node]) < AHEAD and not node.shutting_down:
            unit = self._next_unit(node)
            if unit is None:
                node.shutdown()
                return
            places = {test: index for index, test in enumerate(self._ids[node])}
            # those that an option such as --last-failed deselects later are no tests of the worker
            given = [places[test] for test in unit.tests if test in places]
            if not given:
                continue
            self._pending[node] += given
            node.send_runtest_some(given)

    def _next_unit(self, node: WorkerController) -> Unit | None:
        """Takes what a worker runs next off its queue; None if nothing is left for it."""
        pools = pools_of_worker(node)
        queue = self._queues[pools]
        if time.monotonic() > self._ends_s:
            self.left += [test for unit in queue for test in unit.tests]
            queue.clear()
        if node in self._front[pools]:
            return queue.popleft() if queue else None
        return queue.pop() if queue and not queue[-1].costly else None


def pools_of_worker(node: WorkerController) -> frozenset[Pool]:
    """What a worker is for."""
    return frozenset(Pool(one) for one in node.workerinput["pools"])


def units_file(node: WorkerController) -> Path:
    """Where a worker writes its units before it reports its tests."""
    return Path(node.workerinput["units"])
