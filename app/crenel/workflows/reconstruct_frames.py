"""Points of recorded frames in the arm frame (Eq. 9), ready to be written."""

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from crenel.errors import OperationError
from crenel.formats.clouds.points import Points, pack_points
from crenel.formats.file_names import display_path
from crenel.formats.recording.blocks import Profiles, read_profiles
from crenel.formats.recording.decoders import StripeRecord
from crenel.formats.recording.stream import Block, RecordedFrame
from crenel.formats.recording.wire_format import AXIS, HEIGHT, WIDTH
from crenel.formats.results.calibration import Calibration
from crenel.messages.message import message
from crenel.metrology.sensor.triangulation import scan_points
from crenel.metrology.stripe import extract_stripe
from crenel.metrology.transforms import Floats

Counts = NDArray[np.int64]


@dataclass(frozen=True)
class FrameReconstruction:
    """The origin of recorded frames, and the calibration for their points."""

    path: Path
    calibration: Calibration

    def check_size(self, number: int, width_px: int, height_px: int) -> None:
        """Raises ``OperationError`` if a frame does not have the size of the calibrated sensor."""
        camera = self.calibration.camera
        if (width_px, height_px) != (camera.width_px, camera.height_px):
            raise OperationError(
                "image-size",
                message(
                    "frame-has-pixels",
                    path=display_path(self.path),
                    number=number,
                    width_px=width_px,
                    height_px=height_px,
                ),
                message(
                    "calibration-is-for-pixels", width=camera.width_px, height=camera.height_px
                ),
                message("give-calibration-sensor-took-recording"),
            )


def reconstruct_frames(
    placing: FrameReconstruction,
    block: Block,
    frames: Sequence[RecordedFrame],
    poses: Floats,
    first_number: int,
) -> tuple[Points, Counts]:
    """Points of a block's frames, and the number of stripe pixels of each frame (F,).

    Args:
        poses: (F, 4, 4) ``T_arm_sensor`` at each frame's stamp; NaN if unknown.
        first_number: number of the first frame; the others follow.

    Raises:
        OperationError: a frame differs in size from the calibration, or cannot be read.
    """
    pieces: list[Points] = []
    counts = np.zeros(len(frames), dtype=np.int64)
    for first, last, stripes in _stripe_runs(placing, block, frames, first_number):
        counts[first:last] = stripes.count
        pieces.append(
            _reconstruct_points(placing, stripes, poses[first:last], first_number + first)
        )
    return np.concatenate(pieces), counts


def _stripe_runs(
    placing: FrameReconstruction, block: Block, frames: Sequence[RecordedFrame], first_number: int
) -> list[tuple[int, int, Profiles]]:
    """Intervals of frames whose stripes are processed together, by their first and last + 1."""
    rows = [frame.source for frame in frames if isinstance(frame.source, int)]
    if len(rows) == len(frames):
        table = block.stripes[rows]
        for i, row in enumerate(table[:, [WIDTH, HEIGHT]].tolist()):
            placing.check_size(first_number + i, *row)
        if (table[:, AXIS] == table[0, AXIS]).all():
            return [(0, len(frames), read_profiles(block.chunk, table))]
    return [
        (i, i + 1, _single_stripe(placing, block, frame, first_number + i))
        for i, frame in enumerate(frames)
    ]


def _single_stripe(
    placing: FrameReconstruction, block: Block, frame: RecordedFrame, number: int
) -> Profiles:
    """The stripe of one frame, extracted if its picture was recorded."""
    source = frame.source
    if isinstance(source, int):
        placing.check_size(number, *block.stripes[source, [WIDTH, HEIGHT]].tolist())
        return read_profiles(block.chunk, block.stripes[source : source + 1])
    if isinstance(source, StripeRecord):
        placing.check_size(number, source.width_px, source.height_px)
        stripe = source.stripe
    else:
        picture = source.picture()
        placing.check_size(number, picture.shape[1], picture.shape[0])
        use = placing.calibration
        stripe = extract_stripe(picture, use.stripe_axis, bounds=use.line_bounds)
    count = np.array([len(stripe.u)])
    return Profiles(count, stripe.u, stripe.v, stripe.intensity, stripe.sigma_px, stripe.axis)


def _reconstruct_points(
    placing: FrameReconstruction, stripes: Profiles, poses: Floats, first_number: int
) -> Points:
    use = placing.calibration
    points_mm, spread = scan_points(
        use.camera,
        use.plane,
        stripes.u,
        stripes.v,
        stripes.sigma_px,
        stripes.axis,
        stripes.count,
        poses,
    )
    numbers = first_number + np.arange(len(poses))
    return pack_points(points_mm, stripes.intensity, spread, np.repeat(numbers, stripes.count))
