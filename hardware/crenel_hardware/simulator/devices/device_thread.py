"""The thread of a simulated device."""

from crenel.loops import Loop

BATCH_S = 0.01
"""Samples leave a device in batches as often as this, each with its own time."""


class ThreadedDevice:
    """A device whose ``_serve`` is called every ``BATCH_S`` on a thread of its own.

    Args:
        name: of the thread.
    """

    def __init__(self, name: str) -> None:
        self._thread_name = name
        self._loop: Loop | None = None

    def start(self) -> None:
        """Begins to serve."""
        self._begin()
        self._loop = Loop(self._thread_name, self._serve, BATCH_S)
        self._loop.start()

    def stop(self) -> None:
        """Ends the thread, then every connection; idempotent."""
        if self._loop is not None:
            self._loop.stop(None)
            self._loop = None
        self._release()

    def _begin(self) -> None:
        """Before the thread starts."""

    def _serve(self) -> None:
        raise NotImplementedError

    def _release(self) -> None:
        """Ends every connection."""
        raise NotImplementedError
