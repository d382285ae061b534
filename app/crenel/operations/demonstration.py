"""The whole demonstration by the simulated operator: calibration, acceptance and a scan."""

import secrets
import threading
import time
from collections.abc import Callable

from crenel.errors import OperationError
from crenel.guide.calibration.commands import COMMANDS
from crenel.guide.calibration.guide import CalibrationGuide
from crenel.guide.common.simulated_scan import SimulatedScan, no_simulation_error
from crenel.guide.common.validity import Page
from crenel.loops import start_worker
from crenel.messages.message import Text, message
from crenel.station.activity import Activities
from crenel.station.bus import Bus
from crenel.station.jobs import Jobs
from crenel.station.scan.scanner import Scanner
from crenel.wire.schema import DemonstrationState

TOPIC = "demonstration"
ACCEPT_S, SCAN_S = 10, 5
"""How long the count-downs last before what a person would decide."""
ATTEMPTS = 3
"""At a calibration: a busy machine loses a device for a moment."""
READY_S = 10.0
"""Until the new calibration is in use, and a refusal of the simulated operator is known."""
LOOK_S = 0.1


class _StoppedError(Exception):
    """Somebody stopped it, or goes on by hand."""


class Demonstration:
    """Lets the simulated operator do everything once; any thread may call it."""

    def __init__(
        self,
        bus: Bus,
        jobs: Jobs,
        guide: CalibrationGuide,
        simulated_scan: SimulatedScan,
        scanner: Scanner,
        activities: Activities,
    ) -> None:
        self._bus, self._jobs, self._guide = bus, jobs, guide
        self._simulated_scan, self._scanner, self._activities = simulated_scan, scanner, activities
        self._lock = threading.Lock()
        self._ending = threading.Event()
        self._worker: threading.Thread | None = None
        self.state = DemonstrationState()
        bus.publish(TOPIC, self.state)

    def start(self) -> None:
        """Begins; nothing happens while it runs already.

        Raises:
            OperationError: ``no-simulation`` on real devices, ``busy`` while a job runs, or
                another activity has the arm.
        """
        with self._lock:
            if self.state.running:
                return
            if self._guide.station.simulated_operator is None:
                raise no_simulation_error()
            if (job := self._jobs.current) is not None:
                raise OperationError(
                    "busy",
                    message("cannot-start", title=message("demonstration")),
                    message("still-running", title=job.title),
                    message("wait-until-has-ended"),
                )
            self._guide.start()
            self._ending.clear()
            self._show("calibrate", message("demonstration-calibrates"))
            self._worker = start_worker("demonstration", self._run)

    def stop(self) -> None:
        """Ends it where it is; what has been taken is kept. Idempotent."""
        if self.state.running:
            self._ending.set()
            self._guide.stop_simulation()
            self._simulated_scan.stop()

    def close(self, timeout_s: float) -> None:
        """Ends it, and waits for that."""
        self.stop()
        if self._worker is not None:
            self._worker.join(timeout_s)

    def _run(self) -> None:
        try:
            self._calibrate()
            self._accept()
            self._scan()
        except _StoppedError:
            self._bus.event(TOPIC, message("demonstration-stopped"), "attention")
        except OperationError as refusal:
            self._bus.event("refused", refusal.text, "bad")
        finally:
            self._set(DemonstrationState())

    def _calibrate(self) -> None:
        guide = self._guide
        for _ in range(ATTEMPTS):
            if guide.state.step == "review":
                return
            declined = guide.declined
            self._command("run_simulation", all=True)
            self._wait(lambda: not guide.simulation_running and self._jobs.current is None)
            if guide.state.step != "review":
                with guide.changed:  # the reason follows the end of the job
                    if not guide.changed.wait_for(lambda: guide.declined > declined, READY_S):  # noqa: B023
                        raise _StoppedError
        if guide.state.step != "review":
            raise OperationError(
                "demonstration",
                message("demonstration-not-calibrated"),
                remedy=message("look-last-message-let-simulation-try"),
            )

    def _accept(self) -> None:
        """A calibration that should not be used is left to a person."""
        guide, rev = self._guide, self._guide.rev
        self._count_down(
            "calibrate", message("demonstration-accepts"), ACCEPT_S, lambda: guide.rev != rev
        )
        if guide.state.ended == "accepted":
            return
        main = next((one.name for one in guide.view().actions if one.primary), "")
        if guide.rev != rev or main != "accept":
            raise _StoppedError
        self._command("accept")

    def _scan(self) -> None:
        until_s = time.monotonic() + READY_S
        self._wait(lambda: self._scanner.why_not() is None or time.monotonic() > until_s)
        if (refusal := self._scanner.why_not()) is not None:
            raise refusal
        begun = self._scanner.recording
        self._count_down(
            "scan", message("demonstration-scans-soon"), SCAN_S, lambda: begun() is not None
        )
        self._show("scan", message("demonstration-scans"))
        with self._activities.using("scan"):
            self._simulated_scan.start()
        self._wait(lambda: not self._simulated_scan.running and self._scanner.recording() is None)

    def _command(self, name: str, **args: object) -> None:
        guide = self._guide
        with guide.lock:
            COMMANDS.run(guide, name, args, guide.rev, secrets.token_hex(16))

    def _count_down(
        self, page: Page, text: Text, seconds: int, decided: Callable[[], bool]
    ) -> None:
        """Ends early once a person has decided."""
        for left in range(seconds, 0, -1):
            self._show(page, text, left)
            until_s = time.monotonic() + 1.0
            self._wait(lambda: decided() or time.monotonic() > until_s)  # noqa: B023
            if decided():
                return

    def _wait(self, ready: Callable[[], bool]) -> None:
        while not ready():
            self._ending.wait(LOOK_S)
            self._check_going()
        self._check_going()

    def _check_going(self) -> None:
        if self._ending.is_set():
            raise _StoppedError

    def _show(self, page: Page, text: Text, decides_in_s: int | None = None) -> None:
        self._set(DemonstrationState(True, page, text, decides_in_s))

    def _set(self, state: DemonstrationState) -> None:
        self.state = state
        self._bus.publish(TOPIC, state)
