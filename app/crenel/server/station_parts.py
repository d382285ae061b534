"""What makes one station differ from another."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from pathlib import Path

from crenel.gauges.plan.document_gauge import DEFAULT_LIMITS, VerificationLimits
from crenel.gauges.plan.maths_temperature import TEMPERATURE_LIMITS, TemperatureLimits
from crenel.guide.common.simulated_operator import SimulatedOperator
from crenel.guide.common.validity import DUE, DueLimits
from crenel.metrology.decision import GUARDED_95, DecisionRule
from crenel.metrology.limits import LIMITS, Limits
from crenel.operations.device_setup import StationDevices
from crenel.operations.services import MonitoringSettings
from crenel.security.console_code import new_code
from crenel.single_sign_on.settings import SignInSettings
from crenel.station.pulses.pulse_trigger import TriggerSettings
from crenel_hardware.interfaces import ArmDriver, SensorDriver


@dataclass(frozen=True)
class StationParts:
    """The properties in which stations differ."""

    name: str
    data: Path
    arm: Callable[[], ArmDriver] | None = None
    """None: by ``devices``, as the sensor."""
    sensor: Callable[[], SensorDriver] | Mapping[str, Callable[[], SensorDriver]] | None = None
    """A driver, or one for each of several sensors by its name."""
    hosts: tuple[str, ...] = ()
    simulated_operator: SimulatedOperator | None = None
    """The operator of the simulated station."""
    limits: Limits = LIMITS
    """Limits for the verdict on a calibration."""
    verification: VerificationLimits = DEFAULT_LIMITS
    """Limits for a verification if its gauge has none."""
    rule: DecisionRule = GUARDED_95
    """By which everything is judged."""
    temperature_limits: TemperatureLimits = TEMPERATURE_LIMITS
    """How steady artefact and arm have to be in a performance test."""
    due: DueLimits = DUE
    """When checks are due again."""
    guest: str | None = None
    """The account that a link on the console signs in, for a demonstration or a replay."""
    code: str = field(default_factory=new_code)
    """The output on the console."""
    trigger: TriggerSettings | None = None
    """How the arm triggers the camera, if it does."""
    devices: StationDevices = field(default_factory=StationDevices)
    """The choice of the devices, which the Devices page can change."""
    monitoring: MonitoringSettings = field(default_factory=MonitoringSettings)
    """Recipients of notifications, and further services."""
    sign_in: SignInSettings | None = None
    """The provider of the plant's accounts."""
