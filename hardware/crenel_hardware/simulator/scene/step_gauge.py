"""The step gauge that the simulated operator sets up about the arm's reach; it is not rendered."""

from dataclasses import dataclass

import numpy as np

from crenel_hardware.simulator.devices.kinematics import Floats

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
