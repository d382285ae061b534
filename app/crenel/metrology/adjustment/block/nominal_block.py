"""What a calibration found out about a block of which only the drawing is known."""

from dataclasses import dataclass

import numpy as np

from crenel.messages.message import Message, join, message, quantity
from crenel.metrology.adjustment.core.gauss_newton import AdjustmentResult
from crenel.metrology.calibration.findings import CalibrationFinding
from crenel.metrology.targets.block_readings import centre_axes
from crenel.metrology.targets.crenellated_block import Crenellated
from crenel.metrology.transforms import Floats

# A dimension whose standard uncertainty is still this share of what the drawing leaves was not
# separated from the other unknowns.
UNDETERMINED = 0.5


@dataclass(frozen=True)
class BlockEstimate:
    """The edges of a nominal block as estimated.

    ``off_mm`` (B,) and ``sd_mm`` (B,) are beside the drawing, after the common shift along each
    axis, which is the choice of the frame; ``undetermined`` names the dimensions that neither
    pictures nor contact points separate from the other unknowns.
    """

    off_mm: Floats
    sd_mm: Floats
    undetermined: tuple[str, ...]


def estimate_block(found: AdjustmentResult) -> BlockEstimate:
    """The edges of the block with their uncertainty, from an adjustment in which they are free.

    All poses see the same edges, so that an error of an edge is common to them: more poses of the
    same kind do not average it out.
    """
    prior = found.problem.prior
    own = found.layout.coordinates
    covariance = found.uncertainty[own, own]
    count = len(prior.names) - 5
    centring = centre_axes(count)
    off_mm = centring @ (found.state.coordinates - prior.coordinates)
    sd_mm = np.sqrt(np.diag(centring @ covariance @ centring.T))
    dimensions = {
        "width": (count - 1, 0),
        "depth": (count + 1, count),
        "height": (count + 2, count + 3),
        "base": (count + 3, count + 4),
    }
    undetermined = []
    for name, (high, low) in dimensions.items():
        by = np.zeros(len(prior.names))
        by[high], by[low] = 1.0, -1.0
        if by @ covariance @ by > UNDETERMINED**2 * (by**2 @ prior.sd**2):
            undetermined.append(name)
    return BlockEstimate(off_mm, sd_mm, tuple(undetermined))


def nominal_findings(block: Crenellated, found: AdjustmentResult) -> list[CalibrationFinding]:
    """How far the edges lie beside the drawing, and which dimensions stay open."""
    if not block.is_nominal:
        return []
    made = estimate_block(found)
    edges = slice(0, len(block.edges_x_mm))
    text = message(
        "block-edges-estimated",
        beside=quantity(1e3 * float(np.abs(made.off_mm[edges]).max()), "µm"),
        known=quantity(1e3 * float(np.sqrt(np.mean(made.sd_mm[edges] ** 2))), "µm"),
    )
    findings = [CalibrationFinding("neutral", "block-estimated", text)]
    if made.undetermined:
        names = join([_dimension(name) for name in made.undetermined])
        findings.append(
            CalibrationFinding(
                "neutral",
                "block-undetermined",
                message("block-dimensions-undetermined", names=names),
                message("touch-opposite-faces-tilt-more"),
            )
        )
    return findings


def _dimension(name: str) -> Message:
    return message("block-dimension", name=name)
