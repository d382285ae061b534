"""Prediction, without noise, of what a picture of the block would show from a new pose."""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from app.metrology.adjustment.block.observations import BlockView
from app.metrology.calibration.laser_plane_fit import EDGE_MARGIN_PX
from app.metrology.detection.detect_block import EdgePoints
from app.metrology.detection.visibility import visible_parts
from app.metrology.sensor.camera import Camera, project
from app.metrology.sensor.laser_plane import LaserPlane
from app.metrology.stripe import Stripe
from app.metrology.targets.crenellated_block import Crenellated
from app.metrology.transforms import Floats

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
    edges = [
        points
        for part in visible_parts(block, camera.centre_mm)
        if part.regions[0] != part.regions[1]
        and len(
            (points := _predict_edge(camera, part.edge, part.start_mm, part.end_mm, seeing)).uv_px
        )
    ]
    stripe, level = _predict_stripe(camera, plane, block, seeing)
    return BlockView(block, tuple(_join_parts(edges)), (), stripe, level)


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


def _predict_edge(
    camera: Camera, name: str, start_mm: Floats, end_mm: Floats, seeing: ObservationNoise
) -> EdgePoints:
    ends = project(camera, np.array([start_mm, end_mm]))
    length = float(np.linalg.norm(ends[1] - ends[0]))
    step = EDGE_STEP_PX * seeing.bin_size
    count = int(max(length - 2 * END_PX, 0.0) / step)
    share = (END_PX + step * (np.arange(count) + 0.5)) / max(length, 1.0)
    uv = project(camera, start_mm + share[:, None] * (end_mm - start_mm))
    uv = uv[inside(camera, uv, END_PX)]
    across = np.array([-(ends[1] - ends[0])[1], (ends[1] - ends[0])[0]]) / max(length, 1e-9)
    sigma = np.full(len(uv), seeing.edge_px * seeing.sd_factor)
    return EdgePoints(name, uv, np.broadcast_to(across, uv.shape), sigma)


def _join_parts(parts: Sequence[EdgePoints]) -> list[EdgePoints]:
    """The parts of one edge as one edge."""
    by_name: dict[str, list[EdgePoints]] = {}
    for part in parts:
        by_name.setdefault(part.edge, []).append(part)
    return [
        replace(
            own[0],
            uv_px=np.concatenate([part.uv_px for part in own]),
            normal=np.concatenate([part.normal for part in own]),
            sigma_px=np.concatenate([part.sigma_px for part in own]),
        )
        for own in by_name.values()
    ]


def _predict_stripe(
    camera: Camera, plane: LaserPlane, block: Crenellated, seeing: ObservationNoise
) -> tuple[Stripe, np.ndarray[tuple[int, ...], np.dtype[np.str_]]]:
    """The stripe on crests and floors, where the camera sees it."""
    x = np.asarray(block.edges_x_mm)
    spans = [("crest", block.crest_z_mm, *pair) for pair in zip(x[0::2], x[1::2], strict=True)]
    spans += [("floor", block.floor_z_mm, *pair) for pair in zip(x[1:-1:2], x[2::2], strict=True)]
    uv, level = [np.zeros((0, 2))], [""][:0]
    for name, z, left, right in spans:
        at_x = np.linspace(left, right, 400)
        n = plane.normal
        y = (plane.offset_mm - n[0] * at_x - n[2] * z) / n[1]
        on = (y > block.front_y_mm + 0.5) & (y < block.back_y_mm - 0.5)
        points = np.column_stack([at_x, y, np.full(len(at_x), z)])[on]
        if len(points) < 2:
            continue
        pixels = project(camera, points)
        step = float(np.linalg.norm(pixels[-1] - pixels[0])) / max(len(pixels) - 1, 1)
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
