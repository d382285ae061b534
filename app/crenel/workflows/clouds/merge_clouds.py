"""Makes one cloud of several, whose points all lie in the frame of one arm."""

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from crenel.formats.clouds.cuts import read_kept_pieces
from crenel.formats.clouds.files import cloud_writer
from crenel.progress import Progress, no_progress


@dataclass(frozen=True, slots=True)
class MergedPart:
    """What a cloud has become in the merged one."""

    points: int
    first_frame: int
    """Its frames are numbered from here on."""


def merge_clouds(
    clouds: Sequence[tuple[Path, int]], output: Path, progress: Progress = no_progress
) -> list[MergedPart]:
    """Writes all points of some clouds into one file; each keeps its own uncertainty, and what
    was cut away of a scan stays away.

    Args:
        clouds: ``cloud.ply`` of each scan, with the number of its frames.
        output: replaced when it is complete, in the format by its name.

    Raises:
        OperationError: one of the clouds cannot be read, or the output cannot be written.
    """
    parts: list[MergedPart] = []
    first_frame = 0
    with cloud_writer(output) as writer:
        for number, (path, frames) in enumerate(clouds):
            before, last_frame = writer.points, frames - 1
            for points, share in read_kept_pieces(path):
                last_frame = max(last_frame, int(np.max(points["frame"], initial=0)))
                points["frame"] += first_frame
                writer.append(points)
                progress((number + share) / len(clouds), path.parent.name)
            parts.append(MergedPart(writer.points - before, first_frame))
            first_frame += last_frame + 1
    return parts
