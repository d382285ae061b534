"""Prediction, without noise, of what a picture of the block would show from a new pose."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from crenel.metrology.adjustment.block.observations import BlockView
from crenel.metrology.calibration.laser_plane_fit import EDGE_MARGIN_PX
from crenel.metrology.detection.detect_block import EdgePoints
from crenel.metrology.detection.edges.stations import number_points
from crenel.metrology.detection.visibility import VisiblePart, visible_parts
from crenel.metrology.sensor.camera import Camera, project
from crenel.metrology.sensor.laser_plane import LaserPlane
from crenel.metrology.stripe import Stripe
from crenel.metrology.targets.crenellated_block import Crenellated
from crenel.metrology.transforms import Floats

# Spacing of measured points.
EDGE_STEP_PX = 5.0
STRIPE_STEP_PX = 1.0
# Points closer than this to the end of an edge are disturbed by the adjacent edge.
END_PX = 4.0


@dataclass(frozen=True)
class ObservationNoise:
    """Noise of the measurements in pictures: standard deviations of one edge point, of one corner
    of a chessboard, and of one stripe point.

    ``merged`` points are combined into one of equal weight, which is sufficient for predicting
    uncertainty.
    """

    edge_px: float = 0.09
    corner_px: float = 0.04
    stripe_px: float = 0.11
    axis: str = "u"
    bin_size: int = 1

    @property
    def sd_factor(self) -> float:
        """Standard deviation of several points together, from that of one point."""
        return float(self.bin_size**-0.5)


def predict_view(
    camera: Camera, plane: LaserPlane, block: Crenellated, seeing: ObservationNoise
) -> BlockView:
    """Edge and stripe points of the block as a camera would measure them.

    Args:
        camera, plane: with the block's frame as sensor frame.
    """
    edges = _predict_edges(camera, visible_parts(block, camera.centre_mm), seeing)
    stripe, level = _predict_stripe(camera, plane, block, seeing)
    return BlockView(block, tuple(edges), (), stripe, level)


def visible_share(camera: Camera, block: Crenellated) -> float:
    """Share of the block's eight outer corners that lie in the picture."""
    box = np.array(
        [
            [x, y, z]
            for x in (block.edges_x_mm[0], block.edges_x_mm[-1])
            for y in (block.front_y_mm, block.back_y_mm)
            for z in (block.floor_z_mm, block.crest_z_mm)
        ]
    )
    return float(np.mean(inside(camera, project(camera, box), 0.0)))


def _predict_edges(
    camera: Camera, parts: Sequence[VisiblePart], seeing: ObservationNoise
) -> list[EdgePoints]:
    """Points along the parts at which two different regions meet; those of one edge together."""
    parts = [part for part in parts if part.regions[0] != part.regions[1]]
    first = np.array([part.start_mm for part in parts]).reshape(-1, 3)
    last = np.array([part.end_mm for part in parts]).reshape(-1, 3)
    begin_px, end_px = np.split(project(camera, np.concatenate([first, last])), 2)
    along = end_px - begin_px
    length = np.linalg.norm(along, axis=1)
    step = EDGE_STEP_PX * seeing.bin_size
    count = (np.maximum(length - 2 * END_PX, 0.0) / step).astype(np.int64)
    of, within = number_points(count)
    share = (END_PX + step * (within + 0.5)) / np.maximum(length, 1.0)[of]
    uv = project(camera, first[of] + share[:, None] * (last - first)[of])
    seen = inside(camera, uv, END_PX)
    uv, of = uv[seen], of[seen]
    across = np.column_stack([-along[:, 1], along[:, 0]]) / np.maximum(length, 1e-9)[:, None]
    names = np.array([part.edge for part in parts], dtype=object)[of]
    sigma_px = seeing.edge_px * seeing.sd_factor
    edges = []
    for name in dict.fromkeys(names):
        own = names == name
        edges.append(EdgePoints(name, uv[own], across[of[own]], np.full(int(own.sum()), sigma_px)))
    return edges


def _predict_stripe(
    camera: Camera, plane: LaserPlane, block: Crenellated, seeing: ObservationNoise
) -> tuple[Stripe, np.ndarray[tuple[int, ...], np.dtype[np.str_]]]:
    """The stripe on crests and floors, where the camera sees it."""
    x = np.asarray(block.edges_x_mm)
    spans_mm = [(block.crest_z_mm, *pair) for pair in zip(x[0::2], x[1::2], strict=True)]
    names = ["crest"] * len(spans_mm)
    spans_mm += [(block.floor_z_mm, *pair) for pair in zip(x[1:-1:2], x[2::2], strict=True)]
    names += ["floor"] * (len(spans_mm) - len(names))
    height, left, right = (np.array(own)[:, None] for own in zip(*spans_mm, strict=True))
    at_x = left + (right - left) * np.linspace(0.0, 1.0, 400)
    n = plane.normal
    at_y = (plane.offset_mm - n[0] * at_x - n[2] * height) / n[1]
    on = (at_y > block.front_y_mm + 0.5) & (at_y < block.back_y_mm - 0.5)
    points = np.stack([at_x, at_y, np.broadcast_to(height, at_x.shape)], axis=-1)
    projected = project(camera, points.reshape(-1, 3)).reshape(*at_x.shape, 2)
    uv, level = [np.zeros((0, 2))], [""][:0]
    for name, row, kept in zip(names, projected, on, strict=True):
        pixels = row[kept]
        if len(pixels) < 2:
            continue
        step = float(np.linalg.norm(pixels[-1] - pixels[0])) / (len(pixels) - 1)
        margin = max(int(EDGE_MARGIN_PX / max(step, 1e-6)), 1)
        chosen = pixels[
            margin : -margin : max(1, round(STRIPE_STEP_PX * seeing.bin_size / max(step, 1e-6)))
        ]
        chosen = chosen[inside(camera, chosen, EDGE_MARGIN_PX)]
        uv.append(chosen)
        level += [name] * len(chosen)
    all_uv = np.concatenate(uv)
    bright = np.full(len(all_uv), 150.0)
    sigma = np.full(len(all_uv), seeing.stripe_px * seeing.sd_factor)
    stripe = Stripe(all_uv[:, 0], all_uv[:, 1], bright, sigma, seeing.axis)
    return stripe, np.array(level, dtype="<U5")


def inside(
    camera: Camera, uv_px: Floats, margin_px: float
) -> np.ndarray[tuple[int, ...], np.dtype[np.bool_]]:
    """Mask of the pixels (N, 2) inside the picture, at least a margin away from its border."""
    size = np.array([camera.width_px, camera.height_px])
    return np.asarray(((uv_px > margin_px - 0.5) & (uv_px < size - 0.5 - margin_px)).all(axis=1))
