"""A block that is ordered by the numbers of a sensor, and designed."""

from dataclasses import dataclass, replace
from pathlib import Path
from typing import Literal

from crenel.formats.datasheets.arm import read_arm
from crenel.metrology.design.block_shapes import GivenSizes
from crenel.metrology.design.propose_block import BlockDesign, propose_block
from crenel.metrology.design.usual_arm import usual_arm
from crenel.progress import Progress, no_progress
from crenel.workflows.design.design_files import sensor_numbers


@dataclass(frozen=True)
class BlockOrder:
    """What a block is designed for; ``sensor_numbers`` says what each number is.

    ``arm`` is the file of the arm, None for a usual one; ``arm_version`` tells its contents apart.
    Sizes of the block that are given are kept; None: proposed.
    """

    field_of_view_mm: float
    depth_of_field_mm: float
    angle_deg: float
    sensor: Path | None = None
    standoff_mm: float | None = None
    size_px: tuple[int, int] | None = None
    stripe_axis: Literal["u", "v"] | None = None
    arm: Path | None = None
    arm_version: str = ""
    width_mm: float | None = None
    merlons: int | None = None
    groove_mm: float | None = None
    tolerance_mm: float | None = None


@dataclass(frozen=True)
class OrderedBlock:
    """The block for an order."""

    design: BlockDesign

    def with_name(self, name: str) -> "OrderedBlock":
        """The same block under another name."""
        return OrderedBlock(replace(self.design, block=replace(self.design.block, name=name)))


def design_block(order: BlockOrder, name: str, progress: Progress = no_progress) -> OrderedBlock:
    """Proposes a block for a sensor.

    Args:
        order: the sensor, and the arm that carries it.
        name: of the block.
        progress: called with the share done, 0 to 1, and the current step.

    Raises:
        OperationError: as ``sensor_numbers``, ``read_arm`` and ``propose_block``.
    """
    numbers = sensor_numbers(
        field_of_view_mm=order.field_of_view_mm,
        depth_of_field_mm=order.depth_of_field_mm,
        angle_deg=order.angle_deg,
        datasheet=order.sensor,
        standoff_mm=order.standoff_mm,
        size_px=order.size_px,
        stripe_axis=order.stripe_axis,
    )
    arm = usual_arm() if order.arm is None else read_arm(order.arm)
    given = GivenSizes(order.width_mm, order.merlons, order.groove_mm, order.tolerance_mm)
    return OrderedBlock(propose_block(numbers, arm, name, progress, given))
