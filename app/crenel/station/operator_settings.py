"""The operator's settings of scans: shown to every browser, kept, and applied at once."""

import threading
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Self

from pydantic import ConfigDict, ValidationError, model_validator
from pydantic.functional_validators import ModelWrapValidatorHandler

from crenel.errors import OperationError
from crenel.findings import Finding
from crenel.formats.datasheets.arm import read_any_arm
from crenel.formats.io_errors import error_from_validation
from crenel.formats.results.calibration import read_calibration
from crenel.formats.settings.mask import Corner, Mask
from crenel.formats.settings.scan_settings import ScanOptions, ScanSettings
from crenel.formats.settings.sync import Sync
from crenel.messages.message import Text, message
from crenel.metrology.stripe import check_settings
from crenel.station.bus import Bus
from crenel.station.devices.auto_exposure import better_line_exposure_us
from crenel.station.devices.rig import Rig
from crenel.station.jobs import Job, Jobs, Progress
from crenel.station.preview.preview import Preview
from crenel.station.scan.scanner import Scanner
from crenel.workflows.estimate_delay import delay_findings, estimate_recording_delay
from crenel_hardware.interfaces import Frame

TOPIC = "settings"
Zones = tuple[tuple[Corner, ...], ...]


class SettingsChange(ScanOptions):
    """What is given is set, null is automatic; what is not given stays."""

    model_config = ConfigDict(extra="forbid")

    zones: Zones = ()

    @model_validator(mode="wrap")
    @classmethod
    def _convert_error(cls, given: object, validate: ModelWrapValidatorHandler[Self]) -> Self:
        try:
            return validate(given)
        except ValidationError as error:
            raise error_from_validation("settings", error) from error


class StationSettings(ScanOptions):
    """As the browser shows them; null is automatic."""

    zones: Zones
    """Where nothing is measured: corners in pixels of the full frame."""
    delay: Sync | None
    """In use, or found and not yet used."""
    delay_applied: bool
    finding_delay: bool
    delay_findings: tuple[Finding, ...]
    """What to know before the delay is used: jumps, drift, pictures that do not fit."""
    findings: tuple[Finding, ...]


@dataclass(frozen=True)
class PassRecord:
    """A scan to estimate a delay from."""

    name: Text
    recording: Path
    calibration: Path
    arm: Path
    sensor: str = ""
    """Name of the sensor that the calibration is of, in a recording of several."""


class OperatorSettings:
    """Every method may be called from any thread.

    Args:
        kept: what was set before.
        keep: puts it where it survives a restart.
    """

    def __init__(
        self,
        bus: Bus,
        rig: Rig,
        scanner: Scanner,
        preview: Preview,
        kept: ScanSettings,
        keep: Callable[[ScanSettings], None],
    ) -> None:
        self._bus, self._rig = bus, rig
        self._scanner, self._preview, self._keep = scanner, preview, keep
        self._lock = threading.RLock()
        if kept.sync is not None and kept.sync.drift_ppm:
            # a restart begins the devices' clocks again, and a drift refers to them
            kept = kept.model_copy(update={"sync": None})
            bus.event("delay", message("drifting-delay-ended-with-restart"), "attention")
        self._settings = kept
        self._delay_estimate: Sync | None = None
        self._finding = False
        self._apply()

    @property
    def settings(self) -> ScanSettings:
        return self._settings

    @property
    def finding_delay(self) -> bool:
        """Whether a delay is looked for."""
        return self._finding

    def view(self) -> StationSettings:
        with self._lock:
            now = self._settings
            delay = self._delay_estimate or now.sync
            return StationSettings(
                **now.model_dump(exclude={"mask", "sync", "sensor_exposures_us", "exposure_us"}),
                exposure_us=now.exposure_of_us(self._rig.selected),
                zones=now.mask.zones if now.mask is not None else (),
                delay=delay,
                delay_applied=self._delay_estimate is None and now.sync is not None,
                finding_delay=self._finding,
                delay_findings=() if delay is None else delay_findings(delay),
                findings=self._findings(),
            )

    def change(self, change: SettingsChange) -> None:
        """Sets what the change has; the exposure is that of the selected sensor.

        Raises:
            OperationError: zones that cannot be meant, or while no sensor is connected; or a disk
                that does not take it. Nothing is then changed.
        """
        with self._lock:
            changed = change.model_dump(exclude_unset=True, exclude={"zones", "exposure_us"})
            if "zones" in change.model_fields_set:
                changed["mask"] = self._mask(change.zones)
            settings = self._settings.model_copy(update=changed)
            if "exposure_us" in change.model_fields_set:
                settings = settings.with_exposure_us(self._rig.selected, change.exposure_us)
            check_settings(settings.stripe)
            self._set(settings)
            if change.exposure_us is not None and self._rig.sensor.fresh:
                self._rig.sensor.set_exposure_us(change.exposure_us)

    def expose_by_the_line(self) -> None:
        """Sets the exposure so that the laser's line is at 70 % of full scale; takes a second.

        Raises:
            OperationError: the laser is off, no line is seen, or the sensor is lost; the exposure
                is then as before.
        """
        name, sensor, extraction = self._rig.selected, self._rig.sensor, self._preview.extraction
        if sensor.laser.state == "off":
            raise OperationError(
                "laser-off",
                message("exposure-cannot-be-set-by-line"),
                message("laser-off"),
                message("switch-over-part"),
            )
        seen = True

        def better(frame: Frame, exposure_range_us: tuple[float, float]) -> float | None:
            nonlocal seen
            stripe = extraction.stripe(frame.image)
            seen = len(stripe.u) > 0
            return better_line_exposure_us(frame, stripe, exposure_range_us)

        before_us = sensor.exposure_us
        exposure_us = sensor.auto_exposure(better)
        if not seen:
            if before_us is not None:
                sensor.set_exposure_us(before_us)
            raise OperationError(
                "no-line",
                message("exposure-cannot-be-set-by-line"),
                message("no-line-seen"),
                message("bring-part-into-sensors-range"),
            )
        with self._lock:
            self._set(self._settings.with_exposure_us(name, round(exposure_us, 1)))

    def find_delay(self, jobs: Jobs, taken: Callable[[], PassRecord]) -> None:
        """Looks for the delay in a scan, as a job; raises ``OperationError`` while another runs.

        Args:
            taken: called within the job; it may take the scan first.
        """

        def work(progress: Progress) -> Sync:
            source = taken()
            calibration, arm = read_calibration(source.calibration), read_any_arm(source.arm)
            return estimate_recording_delay(
                source.recording,
                calibration,
                arm,
                lambda share, _: progress(source.name, share),
                str(source.name),
                source.sensor,
            )

        with self._lock:
            jobs.start(message("looking-delay"), work, self._delay_found)
            self._finding = True
        self.publish()

    def use_delay(self, on: bool) -> None:
        """Applies the delay that was found last, or none from now on.

        Raises:
            OperationError: none was found, or a disk that does not take it.
        """
        with self._lock:
            if on and self._delay_estimate is None:
                if self._settings.sync is not None:
                    return  # somebody else was faster
                raise OperationError(
                    "no-delay",
                    message("no-delay-found-yet"),
                    remedy=message("pass-over-plane-find"),
                )
            self._delay_estimate, sync = (
                (None, self._delay_estimate) if on else (self._delay_estimate, None)
            )
            self._set(self._settings.model_copy(update={"sync": sync}))

    def _delay_found(self, job: Job[Sync]) -> None:
        with self._lock:
            self._finding = False
            self._delay_estimate = job.result or self._delay_estimate
        if job.refusal is not None:
            self._bus.event("refused", job.refusal.text, "attention")
        self.publish()

    def _mask(self, zones: Zones) -> Mask | None:
        """The zones as a mask of the connected sensor."""
        if not zones:
            return None
        held = self._settings.mask
        if held is not None and held.zones == zones:
            return held
        info = self._rig.sensor.info
        if info is None:
            raise OperationError(
                "sensor-lost",
                message("zones-cannot-set-now"),
                message("sensor-not-connected"),
                message("wait-until"),
            )
        try:
            return Mask(
                width_px=info.width_px,
                height_px=info.height_px,
                sensor_serial=info.serial_number,
                zones=zones,
            )
        except ValidationError as error:
            raise error_from_validation("zones", error) from error

    def _findings(self) -> tuple[Finding, ...]:
        mask, info = self._settings.mask, self._rig.sensor.info
        if mask is None or info is None:
            return ()
        if (mask.width_px, mask.height_px) == (info.width_px, info.height_px):
            return ()
        return (
            Finding(
                "attention",
                message(
                    "zones-picture-pixels-left-out-sensors",
                    width_px=mask.width_px,
                    height_px=mask.height_px,
                    width_px2=info.width_px,
                    height_px2=info.height_px,
                ),
                message("clear-them-draw-them-again"),
            ),
        )

    def _set(self, settings: ScanSettings) -> None:
        self._keep(settings)
        self._settings = settings
        self._apply()

    def _apply(self) -> None:
        self._scanner.set_settings(self._settings)
        self._preview.set_settings(self._settings)
        self.publish()

    def publish(self) -> None:
        """Shows the settings to every browser, as after the selection of another sensor."""
        self._bus.publish(TOPIC, self.view())
