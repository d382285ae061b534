"""Measures all edges of the located block in the full picture, and fits the camera to them."""

from dataclasses import astuple, dataclass, replace

import cv2
import numpy as np
from numpy.typing import NDArray

from crenel.metrology.detection.edges.camera_from_edges import (
    NO_DISTORTION,
    WITH_K1,
    WITH_K2,
    fit_edges,
    residuals,
)
from crenel.metrology.detection.edges.scatter import estimate_scatter
from crenel.metrology.detection.edges.stations import (
    EdgeStations,
    block_ahead,
    place_stations,
    search_edges,
)
from crenel.metrology.detection.edges.step_fit import (
    StepMeasurements,
    join_stations,
    measure_steps,
    select_stations,
    with_clearance,
)
from crenel.metrology.detection.edges.tool_marks import texture
from crenel.metrology.detection.visibility import Wireframe
from crenel.metrology.robust import median
from crenel.metrology.sensor.camera import Camera, project
from crenel.metrology.transforms import Floats

# One point per this many pixels of edge: the spacing equals the length over which each gathers
# light.
_SPACING_PX = 5.0
# Minimum ratio of a step to its standard deviation for a visible edge.
_SHOWS = 6.0
# In noise, a part of an edge may be visible as a whole, and then its points if they agree.
_PART_SHOWS, _IN_PART = 9.0, 2.5
# Points with a larger standard deviation are not used.
_WORST_PX = 1.0
# A lens term is kept if it exceeds its standard deviation by this factor.
_SIGNIFICANT = 3.0
# Ratio of steps to noise at which points every few pixels are good, and the longest extension.
_GOOD_CONTRAST, _LONGEST = 12.0, 5.0
_NOISY_SPACING_PX = 20.0
# Faint edges are measured in pieces longer by this factor, up to this.
_LONGER, _LONGEST_PX = 5.0, 60.0
# Ratio of the marks along an edge to its step from which the edge cannot be distinguished from
# them.
_MARKS = 0.3
# An edge this many times as wide as the others of the picture is that of a shadow; every this many
# points of it are examined, and this many must show a width.
_SOFTER, _EVERY, _WIDTHS = 1.6, 3, 3


@dataclass(frozen=True)
class EdgeMeasurements:
    """Measured edges and the camera fitted to them.

    ``at``: the stations; ``uv_px`` (N, 2) the positions of their edges; ``sigma_px`` (N,) standard
    deviations, scaled to the scatter along the edges and of whole edges, ``own_px`` (N,) to the
    former only; ``marks_px`` (N,) how far marks along a part may move all of it; ``off_px`` (N,)
    distance from the predicted edge along the normal; ``step`` (N,) its height in grey levels, from
    the second region to the first; ``shows`` (N,) whether the picture shows an edge there; ``used``
    (N,) whether it agrees with its neighbours; ``blur_px``: standard deviation of the blur.
    """

    frame: Wireframe
    camera: Camera
    at: EdgeStations
    uv_px: Floats
    sigma_px: Floats
    sigma_along_px: Floats
    marks_px: Floats
    off_px: Floats
    step: Floats
    shows: NDArray[np.bool_]
    used: NDArray[np.bool_]
    blur_px: float


def smooth_for_search(grey: Floats, coarse_px: float) -> Floats:
    """The picture (H, W), smoothed so that a camera that is ``coarse_px`` off finds its edges."""
    return np.asarray(cv2.GaussianBlur(grey, (0, 0), max(0.8, coarse_px / 4)), dtype=np.float64)


def align_camera_to_edges(
    smooth: Floats, frame: Wireframe, camera: Camera, reach_px: float
) -> Camera | None:
    """The camera whose predicted edges of the block are at the steepest places of the picture.

    Args:
        smooth: (H, W) the picture, ``smooth_for_search``.
        frame: the block.
        camera: a camera for this picture, off by at most ``reach_px``.
        reach_px: its maximum error.

    Returns:
        None if too few edges show, or the block is not in front of the camera.
    """
    for radius in (reach_px, max(0.6 * reach_px, 2.0)):
        if not block_ahead(frame, camera):
            return None
        at = place_stations(frame, camera, 2 * _SPACING_PX, radius + 2)
        offset, slope = search_edges(smooth, at, radius)
        met = np.isfinite(offset)
        steep = np.abs(slope)
        if met.sum() < 30:
            return None
        met &= steep > 0.15 * np.nanpercentile(steep, 80)
        uv = at.uv_px + np.nan_to_num(offset)[:, None] * at.normal
        sigma = np.full(int(met.sum()), 0.5)
        camera, _ = fit_edges(camera, at.points_mm[met], uv[met], at.normal[met], sigma, WITH_K1, 3)
    return camera if block_ahead(frame, camera) else None


def measure_edges(
    masked: Floats, frame: Wireframe, camera: Camera, blur_px: float, certificate_mm: float
) -> EdgeMeasurements | None:
    """Measures every visible edge of the block and fits the camera to them.

    Args:
        masked: (H, W) the picture, 0..255, NaN at pixels that must not count (clipped, lit by
            the laser).
        frame: the block.
        camera: a camera for this picture, from ``align_camera_to_edges``.
        blur_px: approximate standard deviation of the picture's blur.
        certificate_mm: standard uncertainty of the block's coordinates.

    Returns:
        None if too few edges show for a fit.
    """
    blur, contrast = _blur(masked, frame, camera, blur_px)
    # In a noisy picture, each point gathers light along a longer part of its edge.
    spacing = _SPACING_PX * float(np.clip((_GOOD_CONTRAST / contrast) ** 2, 1.0, _LONGEST))
    for _ in range(2):
        fitted = _fit_camera(
            _measure_stations(masked, frame, camera, blur, spacing), WITH_K1, certificate_mm
        )
        if fitted is None:
            return None
        camera = fitted[0].camera
        if not block_ahead(frame, camera):
            return None
    return _fit_significant_lens(
        _measure_stations(masked, frame, camera, blur, spacing), certificate_mm
    )


def refit_without(
    found: EdgeMeasurements, parts: list[int], certificate_mm: float
) -> EdgeMeasurements | None:
    """The survey with the camera fitted to all except some parts; None if too few are left."""
    left_out = np.isin(found.at.part, parts)
    again = replace(found, shows=found.shows & ~left_out)
    return _fit_significant_lens(again, certificate_mm)


def stations_along_x(found: EdgeMeasurements, points_mm: Floats, row: int) -> EdgeStations:
    """Stations at points (N, 3) in the line of an edge along X, as far as they are in the picture.

    Their surroundings are unknown. ``row``: the row of a station on the edge itself.
    """
    camera = found.camera
    uv = project(camera, points_mm)
    step = project(camera, points_mm + np.array([1e-3, 0.0, 0.0])) - uv
    tangent = step / np.linalg.norm(step, axis=1, keepdims=True)
    normal = np.column_stack([-tangent[:, 1], tangent[:, 0]])
    limit = np.array([camera.width_px, camera.height_px]) - 1
    count = len(points_mm)
    at = replace(
        found.at,
        edge=np.full(count, found.at.edge[row]),
        part=np.full(count, found.at.part[row]),
        points_mm=points_mm,
        uv_px=uv,
        normal=normal,
        clearance_px=np.full((count, 2), np.inf),
        length_px=np.ones(count),
    )
    return select_stations(at, np.all((uv > 0) & (uv < limit), axis=1))


def _blur(masked: Floats, frame: Wireframe, camera: Camera, blur: float) -> tuple[float, float]:
    """The picture's blur and the ratio of its steps to its noise, from some of the stations."""
    contrast = 1.0
    for _ in range(4):
        at = with_clearance(place_stations(frame, camera, _NOISY_SPACING_PX, 4.0), blur)
        seen = measure_steps(masked, at, blur, free_blur=True)
        sound = np.isfinite(seen.offset_px) & (np.abs(seen.step) > _SHOWS * seen.step_sigma)
        if sound.sum() < 12:
            break
        contrast = median(np.abs(seen.step[sound]) / seen.noise[sound])
        last, blur = blur, median(seen.blur_px[sound])
        if abs(blur / last - 1) < 0.1:
            break
    return blur, contrast


def _measure_stations(
    masked: Floats, frame: Wireframe, camera: Camera, blur: float, spacing: float
) -> EdgeMeasurements:
    margin = max(4.0, 3.0 * blur)
    at = with_clearance(place_stations(frame, camera, spacing, margin), blur)
    seen = measure_steps(masked, at, blur)
    shows = _find_visible(at, seen)
    # If an edge is too faint for short pieces, long ones may show it.
    wide = min(_LONGER * spacing, _LONGEST_PX)
    faint = ~np.isin(at.part, at.part[shows])
    if faint.any():
        long = with_clearance(place_stations(frame, camera, wide, margin), blur)
        long = select_stations(long, np.isin(long.part, at.part[faint]))
        gathered = measure_steps(masked, long, blur)
        found = _find_visible(long, gathered)
        kept = ~np.isin(at.part, long.part[found])
        fresh = np.isin(long.part, long.part[found])
        at = join_stations(select_stations(at, kept), select_stations(long, fresh))
        seen = _concatenate(seen, kept, gathered, fresh)
        shows = np.concatenate([shows[kept], found[fresh]])
    uv = at.uv_px + np.nan_to_num(seen.offset_px)[:, None] * at.normal
    sigma = np.where(shows, seen.sigma_px, np.nan)
    off = np.where(shows, seen.offset_px, np.nan)
    step = np.where(shows, seen.step, 0.0)
    ratio, moved = texture(masked, at, step, blur)
    # Among marks as strong as itself, an edge cannot be distinguished.
    shows &= ratio < _MARKS
    shows &= ~_find_soft_parts(masked, at, shows, blur)
    return EdgeMeasurements(
        frame, camera, at, uv, sigma, sigma, moved, off, step, shows, shows.copy(), blur
    )


def _find_soft_parts(
    masked: Floats, at: EdgeStations, shows: NDArray[np.bool_], blur: float
) -> NDArray[np.bool_]:
    """Stations (N,) of parts that are less sharp than the picture: borders of shadows."""
    some = np.flatnonzero(shows)[::_EVERY]
    seen = measure_steps(masked, select_stations(at, some), blur, free_blur=True)
    soft = np.zeros(len(shows), dtype=bool)
    for part in np.unique(at.part[some]):
        widths = seen.blur_px[at.part[some] == part]
        widths = widths[np.isfinite(widths)]
        if len(widths) >= _WIDTHS and median(widths) > _SOFTER * blur:
            soft |= at.part == part
    return soft


def _concatenate(
    one: StepMeasurements,
    of_one: NDArray[np.bool_],
    other: StepMeasurements,
    of_other: NDArray[np.bool_],
) -> StepMeasurements:
    """Some values of the first, then some of the second."""
    rows = zip(astuple(one), astuple(other), strict=True)
    return StepMeasurements(*(np.concatenate([a[of_one], b[of_other]]) for a, b in rows))


def _find_visible(at: EdgeStations, seen: StepMeasurements) -> NDArray[np.bool_]:
    """Mask of the stations at which the picture shows an edge: by itself, or as one of a part that
    does."""
    there = np.isfinite(seen.offset_px) & (seen.sigma_px < _WORST_PX)
    ratio = np.where(there, seen.step / seen.step_sigma, 0.0)
    weight = np.where(there, 1 / np.maximum(seen.step_sigma, 1e-6) ** 2, 0.0)
    parts = int(at.part.max()) + 1 if len(at.part) else 0
    total = np.bincount(at.part, weight, parts)
    mean = np.bincount(at.part, weight * np.nan_to_num(seen.step), parts)
    together = (mean / np.sqrt(np.maximum(total, 1e-12)))[at.part]
    as_part = (np.abs(together) > _PART_SHOWS) & (ratio * np.sign(together) > _IN_PART)
    return there & ((np.abs(ratio) > _SHOWS) | as_part)


def _fit_camera(
    found: EdgeMeasurements, free: tuple[int, ...], certificate_mm: float
) -> tuple[EdgeMeasurements, Floats] | None:
    keep = found.shows
    if keep.sum() < 3 * len(free):
        return None
    at = found.at
    edge = at.edge[keep]
    per_edge = np.bincount(edge, minlength=len(found.frame.names))[edge]
    # The certificate's error moves a whole edge together, a mark a whole part of it: distributed
    # over the points, they have the correct weight.
    depth = (at.points_mm @ found.camera.rotation.T + found.camera.translation_mm)[:, 2]
    certificate_px = certificate_mm * found.camera.matrix[0, 0] / depth
    per_part = np.bincount(at.part[keep])[at.part[keep]]
    as_a_whole = per_edge * certificate_px[keep] ** 2 + per_part * found.marks_px[keep] ** 2
    sigma = np.sqrt(found.sigma_px[keep] ** 2 + as_a_whole)
    camera, covariance = fit_edges(
        found.camera, at.points_mm[keep], found.uv_px[keep], at.normal[keep], sigma, free
    )
    off = residuals(camera, at.points_mm, found.uv_px, at.normal)
    used, along, together = estimate_scatter(
        off, at, found.shows, found.sigma_px, found.marks_px, certificate_px
    )
    return replace(
        found,
        camera=camera,
        off_px=np.where(found.shows, off, np.nan),
        used=used,
        sigma_px=found.sigma_px * along * together,
        sigma_along_px=found.sigma_px * along,
    ), covariance


def _fit_significant_lens(
    found: EdgeMeasurements, certificate_mm: float
) -> EdgeMeasurements | None:
    """The fit with as many distortion terms as the edges determine."""
    best = None
    for free, term in ((WITH_K2, 11), (WITH_K1, 10), (NO_DISTORTION, -1)):
        start = found.camera.distortion.copy()
        start[[k for k in (0, 1) if 10 + k not in free]] = 0.0
        begun = replace(found, camera=replace(found.camera, distortion=start))
        fitted = _fit_camera(begun, free, certificate_mm)
        if fitted is None:
            return None
        best, covariance = fitted
        if term < 0:
            break
        value = best.camera.distortion[term - 10]
        if abs(value) > _SIGNIFICANT * np.sqrt(covariance[term, term]):
            break
    return best
