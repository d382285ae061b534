"""The simulated operator sweeps the sensor over the parts on the table, while a scan runs."""

from collections.abc import Callable

from app.errors import OperationError
from app.guide.common.simulated_operator import SimulatedOperator
from app.messages.message import message, word
from app.station.bus import Bus
from app.station.jobs import Job, Jobs, Progress


class SimulatedScan:
    """Lets the simulated operator scan every part once.

    Args:
        operator: returns the simulated operator; None on real devices.
        changed: called at begin and end.
    """

    def __init__(
        self,
        operator: Callable[[], SimulatedOperator | None],
        jobs: Jobs,
        bus: Bus,
        changed: Callable[[], None],
    ) -> None:
        self._operator, self._jobs, self._bus, self._changed = operator, jobs, bus, changed
        self._running = False

    @property
    def running(self) -> bool:
        return self._running

    def start(self) -> None:
        """Begins; nothing happens when it is at work already.

        Raises:
            OperationError: ``no-simulation`` on real devices, ``busy`` while another job runs.
        """
        if self._running:
            return
        operator = self._operator()
        if operator is None:
            raise _no_simulation_error()

        def work(progress: Progress) -> None:
            for done, part in enumerate(operator.parts):
                progress(message("simulation-scans", part=word(part)), done / len(operator.parts))
                if not self._running or not operator.scan_part(part):
                    return

        self._running = True
        try:
            self._jobs.start(message("simulation-work"), work, self._finish)
        except OperationError:
            self._running = False
            raise
        self._changed()

    def pass_over_plate(self) -> bool:
        """Goes over the plate, nearer and away again, within a job of the caller's.

        Returns False when it was stopped. Raises ``OperationError``: ``no-simulation``, or
        ``busy`` while it scans.
        """
        operator = self._operator()
        if operator is None:
            raise _no_simulation_error()
        if self._running:
            raise OperationError(
                "busy", message("simulation-scanning"), remedy=message("stop-first")
            )
        self._running = True
        self._changed()
        try:
            return operator.pass_over_plate()
        finally:
            self._running = False
            self._changed()

    def stop(self) -> None:
        """Ends the sweep under way; idempotent."""
        operator = self._operator()
        if self._running and operator is not None:
            self._running = False
            operator.cancel()

    def _finish(self, job: Job[None]) -> None:
        self._running = False
        if job.refusal is not None:
            self._bus.event("refused", job.refusal.text, "bad")
        self._changed()


def _no_simulation_error() -> OperationError:
    return OperationError(
        "no-simulation",
        message("there-no-simulation-real-devices-2"),
        remedy=message("move-sensor-over-part-yourself"),
    )
