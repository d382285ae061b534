"""Locates the block to about a pixel: hypotheses are drawn, fitted to the edges of the picture, and
judged."""

from dataclasses import dataclass
from typing import Literal

import cv2
import numpy as np
from numpy.typing import NDArray

from crenel.metrology.detection.edges.camera_from_edges import (
    FOCAL_AND_POSE,
    NO_DISTORTION,
    WITH_K1,
    fit_edges,
)
from crenel.metrology.detection.edges.stations import (
    EdgeStations,
    block_ahead,
    place_stations,
    search_edges,
)
from crenel.metrology.detection.search.line_segments import Segments, segments
from crenel.metrology.detection.search.pose_hypotheses import (
    PoseHypothesis,
    mirror_block,
    pose_hypotheses,
)
from crenel.metrology.detection.search.vanishing_points import perpendicular_directions
from crenel.metrology.detection.visibility import Wireframe, wireframe
from crenel.metrology.robust import MEDIAN_OF_NORMAL
from crenel.metrology.sensor.camera import Camera, project
from crenel.metrology.targets.crenellated_block import Crenellated
from crenel.metrology.transforms import Floats

# Ways to suppress texture: of a ground surface, of a coarsely milled one, or of thin lines and
# speckle.
Cleaning = Literal["fine", "coarse", "speckled"]
# Steps of brightness with this slope, in standard deviations of the noise, count as edges.
_CONTRAST = 5.0
_SPACING_PX = 5.0
_MARGIN_PX = 3.0
# Number of hypotheses that are drawn and judged, and number of the best that are fitted to edges.
_SCORED, _REFINED = 60, 8


@dataclass(frozen=True)
class CoarsePose:
    """A camera whose predicted edges of the block match those of the picture.

    ``camera`` is for the picture at its working size; ``support``: share of the predicted and the
    detected edges that match (0 to 1).
    """

    camera: Camera
    mirrored: bool
    support: float


@dataclass(frozen=True)
class SearchResult:
    """The search result: the best hypotheses, refined, best first, and their basis.

    ``explained``: share of the picture's straight segments that follow three perpendicular
    directions; ``segments``: (S, 4) those segments as u0, v0, u1, v1, relative to the picture's
    middle and its longer side.
    """

    poses: tuple[CoarsePose, ...]
    explained: float
    segments: Floats

    @property
    def segment_count(self) -> int:
        return len(self.segments)


def working_image(
    grey: Floats, ignore: NDArray[np.bool_] | None, longer_px: int
) -> tuple[NDArray[np.uint8], NDArray[np.bool_] | None, float]:
    """The picture (0..255) reduced in size, with stretched contrast; its mask; and the scale."""
    height, width = grey.shape
    scale = min(1.0, longer_px / max(height, width))
    size = (round(width * scale), round(height * scale))
    small = cv2.resize(grey.astype(np.float32), size, interpolation=cv2.INTER_AREA)
    low, high = np.percentile(small[::3, ::3], (0.5, 99.5))
    stretched = np.clip((small - low) * (230.0 / max(high - low, 4.0)) + 12.0, 0.0, 255.0)
    mask = None
    if ignore is not None:
        covered = cv2.resize(ignore.astype(np.float32), size, interpolation=cv2.INTER_AREA)
        mask = cv2.dilate((covered > 0).astype(np.uint8), np.ones((3, 3), np.uint8)) > 0
    return np.rint(stretched).astype(np.uint8), mask, scale


def remove_texture(picture: NDArray[np.uint8], cleaning: Cleaning) -> NDArray[np.uint8]:
    """The picture without noise and texture, with the steepness of its steps preserved."""
    if cleaning == "fine":
        soft = cv2.GaussianBlur(picture, (0, 0), 1.0)
        return np.asarray(cv2.bilateralFilter(soft, 9, 25.0, 4.0), dtype=np.uint8)
    if cleaning == "coarse":
        soft = cv2.bilateralFilter(cv2.GaussianBlur(picture, (0, 0), 1.2), 11, 40.0, 5.0)
        return np.asarray(cv2.bilateralFilter(soft, 11, 40.0, 5.0), dtype=np.uint8)
    soft = cv2.medianBlur(cv2.medianBlur(picture, 7), 5)
    return np.asarray(cv2.bilateralFilter(soft, 9, 30.0, 4.0), dtype=np.uint8)


def locate_block(
    picture: NDArray[np.uint8],
    ignore: NDArray[np.bool_] | None,
    block: Crenellated,
    cleaning: Cleaning = "fine",
) -> SearchResult:
    """The likeliest hypotheses of the block in a reduced picture (H, W)."""
    seen = segments(remove_texture(picture, cleaning), ignore)
    frames = perpendicular_directions(seen)
    guesses: list[PoseHypothesis] = []
    for axes in frames:
        best = max((one.votes for one in guesses), default=0.0)
        guesses += pose_hypotheses(axes, seen, block, best)
    explained = max((frame.explained for frame in frames), default=0.0)
    if not guesses:
        return SearchResult((), explained, seen.lines)
    smooth: Floats = np.asarray(
        cv2.GaussianBlur(picture.astype(np.float64), (0, 0), 0.8), dtype=np.float64
    )
    if ignore is not None:
        smooth[ignore] = np.nan
    noise = _slope_noise(smooth)
    forms = {False: wireframe(block), True: wireframe(mirror_block(block))}
    judged = []
    for guess in _distinct_hypotheses(sorted(guesses, key=lambda one: -one.votes)):
        camera = _camera(guess, picture.shape)
        frame = forms[guess.mirrored]
        if not block_ahead(frame, camera):
            continue
        judged.append((_support(smooth, frame, camera, 6.0, noise, seen), guess, camera))
    judged.sort(key=lambda one: -one[0])
    found = []
    for _, guess, camera in judged[:_REFINED]:
        frame = forms[guess.mirrored]
        pulled = _refine_camera(smooth, frame, camera, noise)
        if pulled is not None:
            support = _support(smooth, frame, pulled, 2.0, noise, seen)
            found.append(CoarsePose(pulled, guess.mirrored, support))
    found.sort(key=lambda one: -one.support)
    return SearchResult(tuple(found), explained, seen.lines)


def _distinct_hypotheses(guesses: list[PoseHypothesis]) -> list[PoseHypothesis]:
    """The first hypotheses that differ by more than a hundredth of the distance, or in
    orientation."""
    kept: list[PoseHypothesis] = []
    for guess in guesses:
        reach = 0.01 * float(np.linalg.norm(guess.centre_mm))
        if not any(
            one.mirrored == guess.mirrored
            and abs(one.focal / guess.focal - 1) < 0.03
            and float(np.abs(one.centre_mm - guess.centre_mm).max()) < reach
            and float(np.trace(one.rotation.T @ guess.rotation)) > 2.999
            for one in kept
        ):
            kept.append(guess)
        if len(kept) == _SCORED:
            break
    return kept


def _camera(guess: PoseHypothesis, shape: tuple[int, ...]) -> Camera:
    height, width = shape[:2]
    focal = guess.focal * max(height, width)
    K = np.array([[focal, 0, (width - 1) / 2], [0, focal, (height - 1) / 2], [0, 0, 1.0]])
    return Camera(K, guess.rotation, -guess.rotation @ guess.centre_mm, width, height)


def _slope_noise(smooth: Floats) -> float:
    """Standard deviation of the slope, grey levels per pixel, in areas without edges."""
    slope = 0.5 * (smooth[::2, 2:] - smooth[::2, :-2])
    return max(float(np.nanmedian(np.abs(slope))) / MEDIAN_OF_NORMAL, 0.15)


def _support(
    smooth: Floats, frame: Wireframe, camera: Camera, radius: float, noise: float, seen: Segments
) -> float:
    """Dice's coefficient of predicted and detected edges: 1 if each has a counterpart.

    A counterpart at the limit of the search does not count, nor do edges outside the block.
    """
    at = place_stations(frame, camera, _SPACING_PX, _MARGIN_PX)
    if len(at.edge) == 0:
        return 0.0
    offset, slope = search_edges(smooth, at, radius)
    met = np.abs(slope) > _CONTRAST * noise
    near = 1.0 - (offset[met] / (radius + 0.5)) ** 2
    return (
        2
        * float(at.length_px[met] @ near)
        / (float(at.length_px.sum()) + _segments_within_px(frame, camera, seen))
    )


def _segments_within_px(frame: Wireframe, camera: Camera, seen: Segments) -> float:
    """Weight, px, of the segments whose middles are inside the block's outline."""
    longer = max(camera.width_px, camera.height_px)
    corners = project(camera, np.vstack([frame.starts_mm, frame.ends_mm])).astype(np.float32)
    outline = cv2.convexHull(corners)[:, 0].astype(np.float64)
    middle = (seen.lines[:, :2] + seen.lines[:, 2:]) / 2 * longer
    middle += [(camera.width_px - 1) / 2, (camera.height_px - 1) / 2]
    side = np.roll(outline, -1, axis=0) - outline
    away = middle[:, None] - outline
    across = side[:, 0] * away[..., 1] - side[:, 1] * away[..., 0]
    across = across / np.hypot(*side.T)
    within = (across > -3.0).all(axis=1) | (across < 3.0).all(axis=1)
    return float(seen.weight[within].sum()) * longer


def _refine_camera(smooth: Floats, frame: Wireframe, camera: Camera, noise: float) -> Camera | None:
    """The camera fitted to the steepest places near its predicted edges, with decreasing
    distance."""
    for radius, free in (
        (8.0, FOCAL_AND_POSE),
        (5.0, FOCAL_AND_POSE),
        (4.0, NO_DISTORTION),
        (3.0, WITH_K1),
        (2.0, WITH_K1),
    ):
        at = place_stations(frame, camera, _SPACING_PX, _MARGIN_PX)
        offset, slope = search_edges(smooth, at, radius)
        met = np.isfinite(offset) & (np.abs(slope) > _CONTRAST * noise)
        if met.sum() < 3 * len(free):
            return None
        camera = _refit(camera, at, offset, met, free)
        if not block_ahead(frame, camera):
            return None
    return camera


def _refit(
    camera: Camera, at: EdgeStations, offset: Floats, met: NDArray[np.bool_], free: tuple[int, ...]
) -> Camera:
    uv = at.uv_px[met] + offset[met, None] * at.normal[met]
    sigma = np.full(int(met.sum()), 0.5)
    return fit_edges(camera, at.points_mm[met], uv, at.normal[met], sigma, free, 3)[0]
