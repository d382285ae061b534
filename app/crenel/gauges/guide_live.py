"""What the view of a performance test depends on beside its journal. Pure."""

from collections.abc import Mapping
from dataclasses import dataclass

from crenel.gauges.contact.guide_so_far import ContactSoFar
from crenel.gauges.judgement.document import PerformanceFile
from crenel.gauges.length.guide_so_far import LengthsSoFar
from crenel.gauges.plan.maths_temperature import TemperatureLimits
from crenel.guide.common.datasheet_library import AnyGauge, Gauges
from crenel.guide.common.rules import SessionLive
from crenel.messages.message import Text
from crenel.metrology.arm.kinematics import AnyArm
from crenel.metrology.arm.strained_pose import Strain
from crenel.metrology.transforms import Floats
from crenel.station.devices.link_state import DeviceState


@dataclass(frozen=True, eq=False)
class Places:
    """The places of the part of the test that is touched now."""

    directions: Floats
    """(P, 3) from the sphere's centre, arm frame."""
    flat_deg: Floats
    """(P, 2) as seen along the pole: to the right and away from the arm, in degrees."""
    taken: frozenset[int]
    next: int
    """The one to touch now, -1 of none."""
    tip_flat_deg: tuple[float, float] | None
    """Where the tip is; None before the centre is known."""


@dataclass(frozen=True)
class SeenPatches:
    """What a scan of the sphere has seen so far, about the centre that the touches gave."""

    points: int
    """The points of the sphere within the gate."""
    patches: tuple[tuple[int, int], ...]
    """Points and frames of each of the 25."""


@dataclass(frozen=True, eq=False)
class PerformanceLive(SessionLive):
    """The station as the performance test sees it."""

    active_id: str
    """The calibration in use; empty without one."""
    active_name: str
    gauges: Gauges[AnyGauge]
    """The spheres, plates or length standards among the data folder's gauges."""
    bars: Gauges[AnyGauge]
    """The ball bars of a contact test."""
    artefacts: tuple[AnyGauge, ...]
    """The chosen ones."""
    artefact_problems: tuple[Text, ...]
    """Why they cannot serve."""
    obstacles: Mapping[str, Text]
    """Why gauges cannot serve, by their id."""
    setup_now: Mapping[str, object]
    """The station's settings of scans."""
    plan_changed: bool
    """Whether the plan's file is no longer the one of the first touch."""
    arm: AnyArm | None
    places: Places | None
    lengths: LengthsSoFar | None
    """The lengths of a length test, once its standard was confirmed."""
    contact: ContactSoFar | None
    """The touches and scans of a contact test, once its artefacts were confirmed."""
    temperature_limits: TemperatureLimits
    """How steady artefact and arm have to be."""
    pattern_flat_deg: Floats
    """(25, 2) of the patches, as ``Places.flat_deg``."""
    result: PerformanceFile | None
    arm_link: DeviceState
    sensor_link: DeviceState
    still: bool
    strain: Strain | None
    """Why the pose strains the arm."""
    off_deg: float | None
    """Angle of stylus or camera from the direction of the present articulation; None of none."""
    scan_why_not: Text
    scan_points: int
    seen: SeenPatches | None
    """By the scan that is under way or waits to be measured; None without one."""

    @property
    def artefact(self) -> AnyGauge | None:
        """The chosen one; of a contact test the sphere if it has both; None: none is chosen."""
        return next(iter(self.artefacts), None)
