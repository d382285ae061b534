"""``scan_settings.json``: what an operator sets of a scan. What is not set is automatic.

The delay between arm and camera is measured, and then a part of it.
"""

from collections.abc import Mapping
from dataclasses import replace
from typing import Annotated, ClassVar, Self

from pydantic import Field, StrictBool

from crenel.formats.json_document import Document, Number
from crenel.formats.settings.line_settings import LineFields, Smoothing, extraction_text
from crenel.formats.settings.mask import Mask
from crenel.formats.settings.sync import Sync
from crenel.metrology.stripe import StripeSettings
from crenel.metrology.time_delay.course import NO_DELAY, DelayCourse

Exposure = Annotated[Number, Field(ge=1, le=10_000_000)]
"""Microseconds."""
Blur = Annotated[Number, Field(ge=0.001, le=100)]
"""Millimetres."""

UnattendedStop = Annotated[Number, Field(ge=10, le=3600)]
"""Seconds."""
UNATTENDED_STOP_S = 30.0
"""Unless the operator sets another time."""


class ScanOptions(LineFields):
    """Settings that are a number or a choice; None means automatic, or no smoothing."""

    smoothing_px: Smoothing | None = None
    exposure_us: Exposure | None = None
    blur_limit_mm: Blur | None = None
    record_pictures: StrictBool = False
    unattended_stop_s: UnattendedStop | None = None
    """After so long with nobody in control and the arm still, scan and lasers are stopped."""
    runs_unattended: StrictBool = False
    """Whether a robot cell runs unattended: nobody has to be in control."""


class ScanSettings(ScanOptions, Document):
    """All that is kept."""

    FORMAT: ClassVar[str] = "crenel/scan-settings"

    mask: Mask | None = None
    sync: Sync | None = None
    sensor_exposures_us: Mapping[str, Exposure] | None = None
    """The exposures of several sensors, by their names; ``exposure_us`` is that of a station with
    one."""

    def exposure_of_us(self, sensor: str) -> float | None:
        """The stored exposure of a sensor, whose name is empty if it is the only one."""
        if not sensor:
            return self.exposure_us
        return (self.sensor_exposures_us or {}).get(sensor)

    def with_exposure_us(self, sensor: str, exposure_us: float | None) -> Self:
        """These settings with another exposure of a sensor; None is automatic."""
        if not sensor:
            return self.model_copy(update={"exposure_us": exposure_us})
        exposures_us = {**(self.sensor_exposures_us or {})}
        exposures_us.pop(sensor, None)
        if exposure_us is not None:
            exposures_us[sensor] = exposure_us
        return self.model_copy(update={"sensor_exposures_us": exposures_us or None})

    @property
    def unattended_limit_s(self) -> float | None:
        """After how long unattended scan and lasers are stopped; None for never."""
        if self.runs_unattended:
            return None
        return self.unattended_stop_s or UNATTENDED_STOP_S

    @property
    def stripe(self) -> StripeSettings:
        """What the extraction goes by."""
        return replace(super().stripe, smoothing_px=self.smoothing_px or 0.0)

    @property
    def extraction_text(self) -> str:
        """How stripes are extracted, as JSON for a recording; empty where all is automatic."""
        return extraction_text(self.stripe, self.mask)

    def delay_of(self, arm_serial: str, sensor_serial: str) -> DelayCourse:
        """By how much the arm's stamps are later; 0 where it was found on other devices."""
        sync = self.sync
        if sync is None:
            return NO_DELAY
        pairs = ((sync.arm_serial, arm_serial), (sync.sensor_serial, sensor_serial))
        alike = all(of == now or not of or not now for of, now in pairs)
        return sync.course if alike else NO_DELAY


AUTOMATIC = ScanSettings()
