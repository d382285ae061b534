"""The thread of a simulated device."""

import threading

BATCH_S = 0.01
"""Samples leave a device in batches as often as this, each with its own time."""


class ThreadedDevice:
    """A device whose ``_run`` is a thread's until ``_stopping`` is set.

    Args:
        name: of the thread.
    """

    def __init__(self, name: str) -> None:
        self._thread_name = name
        self._stopping = threading.Event()
        self._thread: threading.Thread | None = None

    def start(self) -> None:
        """Begins to serve."""
        self._stopping.clear()
        self._thread = threading.Thread(target=self._run, name=self._thread_name, daemon=True)
        self._thread.start()

    def stop(self) -> None:
        """Ends the thread, then every connection; idempotent."""
        self._stopping.set()
        if self._thread is not None:
            self._thread.join()
            self._thread = None
        self._release()

    def _run(self) -> None:
        raise NotImplementedError

    def _release(self) -> None:
        """Ends every connection."""
        raise NotImplementedError
