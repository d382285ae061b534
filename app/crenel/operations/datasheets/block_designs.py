"""Blocks that are designed while somebody looks: what each page wants last is done."""

import hashlib
import logging
import os
import threading
import time
from collections import OrderedDict
from dataclasses import dataclass
from functools import partial

from crenel.errors import OperationError
from crenel.loops import start_worker
from crenel.messages.message import Text, message
from crenel.workflows.design.ordered_block import BlockOrder, OrderedBlock, design_block

log = logging.getLogger(__name__)
WANTED_S = 15.0
"""A page that has not asked for so long is closed: it asks several times a second."""
KEPT = 20
"""Designs of which a page may still want the files."""
NICENESS = 10
"""Scans and calibrations go first."""
END_S = 10.0


class _DesignCancelledError(Exception):
    """No page wants the block any more."""


@dataclass(frozen=True)
class DesignProgress:
    """How far a block is designed."""

    share: float
    step: Text


class BlockDesigns:
    """Designs one block at a time, in a thread that ends when no page wants another one.

    Methods may be called from any thread.
    """

    def __init__(self) -> None:
        self._lock = threading.Lock()
        self._wanted: dict[str, tuple[BlockOrder, float]] = {}
        self._kept: OrderedDict[BlockOrder, OrderedBlock | OperationError] = OrderedDict()
        self._thread: threading.Thread | None = None
        self._current: BlockOrder | None = None
        self._progress = DesignProgress(0.0, "")
        self._closed = False

    def ask(self, page: str, order: BlockOrder) -> OrderedBlock | DesignProgress:
        """The block, or how far it is; a page that asks for another one gives up the former.

        Args:
            page: tells the pages apart that ask.
            order: what the block is for.

        Raises:
            OperationError: no block can be designed for this order, as ``design_block``.
        """
        with self._lock:
            found = self._kept.get(order)
            if found is None:
                self._wanted[page] = (order, time.monotonic())
                if self._thread is None and not self._closed:
                    self._thread = start_worker("block-designs", self._work)
                return self._progress if self._current == order else DesignProgress(0.0, "")
            self._wanted.pop(page, None)
            self._kept.move_to_end(order)
        if isinstance(found, OperationError):
            raise found
        return found

    def find(self, design_id: str) -> OrderedBlock:
        """A designed block by its id; raises ``OperationError`` where it is not kept any more."""
        with self._lock:
            for order, found in self._kept.items():
                if isinstance(found, OrderedBlock) and order_id(order) == design_id:
                    return found
        raise OperationError(
            "no-design", message("design-not-kept"), remedy=message("load-the-page-again")
        )

    def close(self) -> None:
        """Ends the work, which is given up. Idempotent."""
        with self._lock:
            self._closed = True
            self._wanted.clear()
            thread = self._thread
        if thread is not None:
            thread.join(END_S)

    def _work(self) -> None:
        if hasattr(os, "setpriority"):  # of this thread only
            os.setpriority(os.PRIO_PROCESS, threading.get_native_id(), NICENESS)
        while (order := self._next()) is not None:
            try:
                found: OrderedBlock | OperationError = design_block(
                    order, "", partial(self._note, order)
                )
            except _DesignCancelledError:
                continue
            except OperationError as refusal:
                found = refusal
            except Exception as error:  # the page shows an error, and the station continues
                log.exception("a block could not be designed")
                found = OperationError(
                    "failed", message("program-failed"), f"{type(error).__name__}: {error}"
                )
            with self._lock:
                self._kept[order] = found
                while len(self._kept) > KEPT:
                    self._kept.popitem(last=False)

    def _next(self) -> BlockOrder | None:
        """The order that has waited longest; None, and the thread ends, if no page waits."""
        with self._lock:
            waiting = [order for order in self._list_orders() if order not in self._kept]
            self._current = next(iter(waiting), None)
            self._progress = DesignProgress(0.0, "")
            if self._current is None:
                self._thread = None
            return self._current

    def _list_orders(self) -> list[BlockOrder]:
        """What pages want that are still open; the caller holds the lock."""
        now_s = time.monotonic()
        self._wanted = {
            page: (order, at_s)
            for page, (order, at_s) in self._wanted.items()
            if now_s - at_s < WANTED_S
        }
        return [order for order, _ in self._wanted.values()]

    def _note(self, order: BlockOrder, share: float, step: Text) -> None:
        with self._lock:
            if order not in self._list_orders():
                raise _DesignCancelledError
            self._progress = DesignProgress(share, step)


def order_id(order: BlockOrder) -> str:
    """Names an order in addresses."""
    return hashlib.sha256(repr(order).encode()).hexdigest()[:20]
