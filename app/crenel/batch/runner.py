"""Has the workers do all tasks, each once, whatever is lost in between."""

import asyncio
import time
from collections import Counter, deque
from collections.abc import Callable, Sequence
from contextlib import suppress
from queue import Empty, SimpleQueue
from typing import TYPE_CHECKING

from crenel.batch.cluster import Cluster
from crenel.batch.patience import GIVE_UP_S, Patience
from crenel.batch.task import PROGRESS_TOPIC, Outcome, Refusal, Task, perform_on_worker
from crenel.formats.json_document import SOFTWARE
from crenel.messages.message import Text, message
from crenel.progress import Progress, no_progress

if TYPE_CHECKING:
    from distributed import Future

WINDOW = 500
"""Tasks that the scheduler has at a time: however many there are, it stays small."""
LOOK_S = 0.5
GATHER_S = 60.0

MOST_TRIES = 6
"""How often a task is tried whose store fails it and can be reached all the same."""
FIRST_RETRY_S = 0.5
"""After which it is tried again; the next times after twice as long each."""

TakeOutcome = Callable[[Task, Outcome], None]
"""Called with what became of each task: it is done, or its outcome has the refusal."""


class Runner:
    """Does tasks on a cluster.

    Args:
        kind: one word, by which Dask's dashboard groups them.
        say: called with what the operator should know meanwhile.
        watch: called with the key of a task and the share of it that is done, meanwhile.
        give_up_s: a store that does not answer for so long is given up.
    """

    def __init__(
        self,
        cluster: Cluster,
        kind: str,
        take: TakeOutcome,
        progress: Progress = no_progress,
        say: Callable[[Text], None] = lambda text: None,
        watch: Callable[[str, float], None] | None = None,
        give_up_s: float = GIVE_UP_S,
    ) -> None:
        self._cluster, self._kind, self._take = cluster, kind, take
        self._progress, self._say, self._watch = progress, say, watch
        self._patience = Patience(say, give_up_s)
        self._waiting: deque[Task] = deque()
        self._running: dict[str, tuple[Future[Outcome], Task]] = {}
        self._ended: SimpleQueue[Future[Outcome]] = SimpleQueue()
        self._failures: Counter[str] = Counter()
        self._delayed: list[tuple[float, Task]] = []
        """When each is tried again, on the monotonic clock."""
        self.tries = 0
        """Tasks that were given to the scheduler; those that were given again count again."""

    def run(self, tasks: Sequence[Task]) -> None:
        """Returns when each has been taken.

        Raises:
            OperationError: the scheduler or a store was away for too long, or refuses everything.
        """
        self._listen()
        self._waiting.extend({task.key: task for task in tasks}.values())
        count = len(self._waiting)
        total = sum(task.size_bytes for task in self._waiting)
        done = taken = 0
        try:
            while self._waiting or self._running or self._delayed:
                self._check_connection()
                self._submit()
                task = self._take_next()
                if task is not None:
                    taken, done = taken + 1, done + task.size_bytes
                    self._progress(done / max(total, 1), f"{taken} / {count}")
        finally:
            futures = [future for future, _ in self._running.values()]
            if futures:
                with suppress(Exception):  # the reason for the end counts
                    self._cluster.client.cancel(futures, force=True)

    def _check_connection(self) -> None:
        """Has everything done again that was under way when the scheduler was lost."""
        if self._cluster.client.status == "running":
            return
        self._waiting.extendleft(task for _, task in self._running.values())
        self._running.clear()
        self._cluster.reconnect(self._say)
        self._listen()

    def _listen(self) -> None:
        """Passes on what workers report of their tasks."""
        watch = self._watch
        if watch is not None:
            self._cluster.client.subscribe_topic(
                PROGRESS_TOPIC, lambda event: watch(event[1]["key"], event[1]["share"])
            )

    def _submit(self) -> None:
        if time.monotonic() < self._patience.next_s:
            return
        now_s = time.monotonic()
        self._waiting.extend(task for due_s, task in self._delayed if due_s <= now_s)
        self._delayed = [(due_s, task) for due_s, task in self._delayed if due_s > now_s]
        client = self._cluster.client
        while self._waiting and len(self._running) < WINDOW:
            task = self._waiting.popleft()
            key = f"{self._kind}-{task.key}"
            future = client.submit(
                perform_on_worker,
                task,
                SOFTWARE.version,
                self._cluster.threads,
                self._watch is not None,
                key=key,
            )
            self.tries += 1
            self._running[key] = future, task
            future.add_done_callback(self._ended.put)

    def _take_next(self) -> Task | None:
        """The next task that is finished for good; None for now."""
        try:
            future = self._ended.get(timeout=LOOK_S)
        except Empty:
            return None
        known, task = self._running.get(str(future.key), (None, None))
        if known is not future or task is None:
            return None
        del self._running[str(future.key)]
        outcome = _outcome_of(future)
        if outcome is None:
            self._waiting.appendleft(task)
        elif outcome.state == "stop":
            assert outcome.refusal is not None
            raise outcome.refusal.error()
        elif outcome.state == "away":
            self._waiting.append(task)
            assert outcome.refusal is not None
            self._patience.note_away(outcome.refusal.error())
        elif outcome.state == "again" and self._failures[task.key] < MOST_TRIES - 1:
            retry_s = FIRST_RETRY_S * 2 ** self._failures[task.key]
            self._failures[task.key] += 1
            self._delayed.append((time.monotonic() + retry_s, task))
        else:
            self._patience.note_back()
            self._take(task, outcome)
            return task
        return None


def _outcome_of(future: "Future[Outcome]") -> Outcome | None:
    """What a future of Dask holds; None if it was lost with a scheduler."""
    try:
        if future.status == "finished":
            return future.result(timeout=GATHER_S)
        if future.status == "error":
            error = future.exception(timeout=GATHER_S)
            what = message("batch-worker-failed", error=type(error).__name__)
            return Outcome("refused", refusal=Refusal("worker-failed", what, str(error)))
    except (Exception, asyncio.CancelledError):
        # a result that was lost with its worker or its scheduler comes in many forms
        return None
    return None
