"""The simulated operator scans: it sweeps the sensor over the parts on the table."""

from collections.abc import Callable

from crenel.errors import OperationError
from crenel.guide.common.simulated_operator import SimulatedOperator
from crenel.messages.message import message, word
from crenel.station.bus import Bus
from crenel.station.jobs import Job, Jobs, Progress
from crenel.station.scan.scanner import Scanner


class SimulatedScan:
    """Lets the simulated operator scan every part once.

    Args:
        operator: returns the simulated operator; None on real devices.
        scanner: what it scans with.
        changed: called at begin and end.
    """

    def __init__(
        self,
        operator: Callable[[], SimulatedOperator | None],
        jobs: Jobs,
        bus: Bus,
        scanner: Scanner,
        changed: Callable[[], None],
    ) -> None:
        self._operator, self._jobs, self._bus, self._changed = operator, jobs, bus, changed
        self._scanner = scanner
        self._running = False

    @property
    def running(self) -> bool:
        return self._running

    def start(self) -> None:
        """Begins, with a scan of its own while none runs, which it ends after its last part.

        Nothing happens when it is at work already.

        Raises:
            OperationError: ``no-simulation`` on real devices, ``busy`` while another job runs, or
                why no scan can start.
        """
        if self._running:
            return
        operator = self._operator()
        if operator is None:
            raise no_simulation_error()
        scans = self._scanner.recording() is None

        def work(progress: Progress) -> None:
            try:
                self._sweep(operator, progress)
            finally:
                if scans:
                    self._scanner.stop()

        self._running = True
        try:
            if scans:
                self._scanner.start("")
            self._jobs.start(message("simulation-work"), work, self._finish)
        except OperationError:
            self._running = False
            if scans:
                self._scanner.stop()
            raise
        self._changed()

    def _sweep(self, operator: SimulatedOperator, progress: Progress) -> None:
        for done, part in enumerate(operator.parts):
            progress(message("simulation-scans", part=word(part)), done / len(operator.parts))
            if not self._running or not operator.scan_part(part):
                return

    def pass_over_plate(self) -> bool:
        """Goes over the plate, nearer and away again, within a job of the caller's.

        Returns False when it was stopped. Raises ``OperationError``: ``no-simulation``, or
        ``busy`` while it scans.
        """
        operator = self._operator()
        if operator is None:
            raise no_simulation_error()
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


def no_simulation_error() -> OperationError:
    """Why the simulated operator can do nothing on real devices."""
    return OperationError(
        "no-simulation",
        message("no-simulation-of-real-devices"),
        remedy=message("move-sensor-over-part-yourself"),
    )
