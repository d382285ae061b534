"""The step gauge that the simulated operator sets up about the arm's reach; it is not rendered."""

from collections.abc import Sequence
from contextlib import suppress
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from crenel_hardware.simulator.devices.kinematics import ArmModel, Floats, UnreachableError
from crenel_hardware.simulator.devices.motion import JointPath
from crenel_hardware.simulator.operator.gauge_operator import GaugeOperator
from crenel_hardware.simulator.operator.on_sphere import LEANS, UP, path_onto_place, unit_vector
from crenel_hardware.simulator.scene.datasheets import GAUGE_SD_MM, NO_EXPANSION, JsonObject

NEAREST_MM = 1.0


@dataclass(frozen=True)
class StepGauge:
    """Faces that all look back along the gauge; lengths are from the first one to each other."""

    lengths_mm: tuple[float, ...] = (100.0, 225.0, 350.0, 475.0, 600.0)

    def face_mm(self, certificate: "StepGauge", length_mm: float, end: int) -> float:
        """Where on this gauge, as truly made, an end (0 or 1) of a certified length is.

        Raises:
            KeyError: the certificate has no such length.
        """
        for certified, true in zip(certificate.lengths_mm, self.lengths_mm, strict=True):
            if abs(certified - length_mm) < NEAREST_MM:
                return true if end else 0.0
        raise KeyError(f"the step gauge has no length of {length_mm} mm")


def draw_true_step_gauge(
    certificate: StepGauge, sd_mm: float, rng: np.random.Generator
) -> StepGauge:
    """The gauge as truly made: each length off its certificate by a few micrometres."""
    off = rng.normal(0.0, 1.0, len(certificate.lengths_mm)) * sd_mm
    return StepGauge(
        tuple(float(one + more) for one, more in zip(certificate.lengths_mm, off, strict=True))
    )


def gauge_start_mm(certificate: StepGauge, middle_mm: Floats, along: Floats) -> Floats:
    """(3,) of the first face of a gauge that is set up about its middle along a direction (3,)."""
    return np.asarray(middle_mm - 0.5 * max(certificate.lengths_mm) * along)


def step_gauge_datasheet(certificate: StepGauge) -> JsonObject:
    """The file of a length standard as the step gauge's certificate has it."""
    return {
        "format": "crenel/length-standard",
        "version": 1,
        "kind": "step-gauge",
        "name": "Simulated step gauge",
        "serial_number": "TWIN-L1",
        "certificate": "simulated",
        **NO_EXPANSION,
        "lengths": [
            {"length_mm": length, "standard_uncertainty_um": 1e3 * GAUGE_SD_MM}
            for length in certificate.lengths_mm
        ],
    }


def path_onto_face(
    arm: ArmModel,
    face_mm: Floats,
    gap_mm: float,
    normal: Floats,
    q_rad: Floats,
    rng: np.random.Generator,
) -> JointPath:
    """From before a face straight onto it, with the stylus across the gauge.

    Args:
        face_mm: (3,) the place on the face, arm frame.
        gap_mm: from there to the tip's centre, with the error of this contact.
        normal: (3,) out of the face.

    Raises:
        UnreachableError: the arm cannot do that with any posture tried.
    """
    to_arm = -np.array([face_mm[0], face_mm[1], 0.0])
    to_arm /= max(float(np.linalg.norm(to_arm)), 1.0)
    for up, towards in LEANS:
        stylus = up * UP + towards * to_arm
        stylus = stylus - (stylus @ normal) * normal
        if np.linalg.norm(stylus) < 0.2:
            continue  # the stylus would come out of the face
        with suppress(UnreachableError):
            return path_onto_place(arm, face_mm, gap_mm, normal, stylus, q_rad, rng)
    raise UnreachableError("the arm cannot touch the face there")


class StepGaugeOperator(GaugeOperator):
    """Touches the step gauge."""

    step_gauge = StepGauge()
    """As its certificate has it."""

    @cached_property
    def _true_gauge(self) -> StepGauge:
        rng = np.random.default_rng(self._seed)
        return draw_true_step_gauge(self.step_gauge, GAUGE_SD_MM, rng)

    def touch_length(
        self, middle_mm: Sequence[float], along: Sequence[float], length_mm: float, end: int
    ) -> bool:
        """Touches an end (0 or 1) of a length of the step gauge and presses the primary button;
        False when cancelled.

        Args:
            middle_mm: (3,) of the gauge where it is set up, arm frame.
            along: (3,) its direction, arm frame.

        Raises KeyError for a length that it does not have, UnreachableError where the arm cannot
        get there.
        """
        direction = unit_vector(along)
        start = gauge_start_mm(self.step_gauge, np.asarray(middle_mm), direction)
        at_mm = self._true_gauge.face_mm(self.step_gauge, length_mm, end)
        with self._executor.move("touching the step gauge"):
            gap_mm = self.planner.gap_mm()
            self._tap(
                lambda q: path_onto_face(
                    self._arm, start + at_mm * direction, gap_mm, -direction, q, self._rng
                )
            )
            return True
        return False
