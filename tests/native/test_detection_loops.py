"""The loops of block detection and of line images: every variant beside plain numpy."""

from collections.abc import Callable, Sequence

import numpy as np
import pytest
from numpy.typing import ArrayLike, NDArray
from scipy.ndimage import map_coordinates

from crenel.metrology.detection.edges.camera_from_edges import residuals_with_jacobian
from crenel.metrology.detection.edges.stations import (
    EdgeStations,
    place_stations,
    sample_profiles,
    search_edges,
)
from crenel.metrology.detection.edges.step_fit import measure_steps
from crenel.metrology.detection.search.line_segments import Segments
from crenel.metrology.detection.search.pose_hypotheses import pose_hypotheses
from crenel.metrology.detection.search.vanishing_points import perpendicular_directions
from crenel.metrology.detection.visibility import find_visible_edges, visible_corners, wireframe
from crenel.metrology.sensor.camera import Camera, project, undistort_pixels
from crenel.metrology.sensor.line_projection import across_lines
from crenel.metrology.sensor.residual_correlation import neighbours_alike, variances_of_lines
from crenel.metrology.transforms import Floats, rotation_from_vector
from crenel.native.library import CRENEL
from tests.metrology.builders import BLOCK

WIDTH, HEIGHT = 640, 512
DISTORTION = np.array([-0.08, 0.05, 1e-3, -2e-3, 0.01])


def as_by_v1(compute: Callable[[], Sequence[ArrayLike]]) -> None:
    """The same by this variant as by the least demanding one."""
    here = compute()
    with CRENEL.using("v1"):
        np.testing.assert_allclose(np.hstack(here), np.hstack(compute()), rtol=1e-9, atol=1e-12)


def camera() -> Camera:
    """Looks at the block from left, before and above it."""
    eye = np.array([-40.0, -90.0, 110.0])
    ahead = -eye / np.linalg.norm(eye)
    right = np.cross(ahead, [0.0, 0.0, 1.0])
    right /= np.linalg.norm(right)
    rotation = np.stack([right, np.cross(ahead, right), ahead])
    K = np.array([[1000.0, 0, WIDTH / 2], [0, 1002.0, HEIGHT / 2], [0, 0, 1.0]])
    return Camera(K, rotation, -rotation @ eye, WIDTH, HEIGHT, DISTORTION)


def drawn() -> Floats:
    """A smooth picture with a step down the middle and a hidden patch."""
    v, u = np.mgrid[0:HEIGHT, 0:WIDTH]
    image = 100 + 20 * np.sin(u / 17) + 15 * np.cos(v / 11) + 60 * np.tanh((u - 320.3) / 1.5)
    image[90:110, 300:340] = np.nan
    return np.asarray(image)


def upright(count: int = 40) -> EdgeStations:
    """Stations down the middle of the picture."""
    at = np.column_stack([np.full(count, 320.0), np.linspace(20, HEIGHT - 20, count)])
    zeros = np.zeros(count, dtype=np.int64)
    normal = np.tile([np.cos(0.02), np.sin(0.02)], (count, 1))
    clearance = np.tile([np.inf, 9.0], (count, 1))
    regions = np.zeros((1, 2), np.int64)
    return EdgeStations(
        zeros, zeros, np.zeros((count, 3)), at, normal, clearance, np.ones(count), regions, 2.5
    )


def cube_segments() -> tuple[Floats, Segments]:
    """Axes of a turned cube, focal length 1.4, and forty segments along its directions."""
    rng = np.random.default_rng(7)
    axes = rotation_from_vector(np.array([0.6, -0.5, 0.2]))
    lines = []
    for k in range(40):
        start = np.array([*rng.uniform(-1.0, 1.0, 2), 4.0])
        end = start + 0.5 * axes[:, k % 3]
        lines.append(1.4 * np.concatenate([start[:2] / start[2], end[:2] / end[2]]))
    at = np.array(lines)
    return axes, Segments(at, np.hypot(*(at[:, 2:] - at[:, :2]).T))


def test_directions_are_those_of_the_segments(variant: str) -> None:
    axes, segments = cube_segments()
    best = perpendicular_directions(segments)[0]
    agreement = np.abs(best.rotation.T @ axes)
    assert agreement.max(axis=0) == pytest.approx(1.0, abs=1e-5)
    assert best.focal == pytest.approx(1.4, rel=0.02)
    assert len(set(best.family[:3].tolist())) == 3
    assert best.explained > 0.99
    as_by_v1(lambda: [one.rotation.ravel() for one in perpendicular_directions(segments)])


def test_directions_alike_are_given_once(variant: str) -> None:
    _, segments = cube_segments()
    found = perpendicular_directions(segments)
    for k, one in enumerate(found):
        for other in found[:k]:
            near = np.abs(one.rotation.T @ other.rotation).max(axis=1).min() > np.cos(np.deg2rad(3))
            assert not (near and abs(np.log(one.focal / other.focal)) <= 0.15)


def test_placings_are_the_same(variant: str) -> None:
    _, segments = cube_segments()
    directions = perpendicular_directions(segments)[0]
    found = pose_hypotheses(directions, segments, BLOCK)
    assert found
    as_by_v1(
        lambda: [[*p.centre_mm, p.votes] for p in pose_hypotheses(directions, segments, BLOCK)]
    )


def test_what_is_seen_is_the_same(variant: str) -> None:
    frame = wireframe(BLOCK)
    centre = camera().centre_mm
    parts = find_visible_edges(frame, centre)
    assert (parts.start < parts.end).all()
    as_by_v1(lambda: [one.ravel() for one in vars(find_visible_edges(frame, centre)).values()])
    shown = visible_corners(BLOCK, centre)
    with CRENEL.using("v1"):
        assert shown == visible_corners(BLOCK, centre)


def nearest_px(at: EdgeStations, ends: NDArray[np.float64], row: int) -> tuple[float, float]:
    """Distances along and against a station's normal to other parts' segments, by solving."""
    clearance = [np.inf, np.inf]
    for part, (start, end) in enumerate(ends.reshape(-1, 2, 2)):
        if part == at.part[row]:
            continue
        along = end - start
        longer = at.half_length_px / np.linalg.norm(along)
        away, share = np.linalg.solve(
            np.column_stack([at.normal[row], -along]), start - at.uv_px[row]
        )
        if -longer <= share <= 1 + longer:
            side = 0 if away >= 0 else 1
            clearance[side] = min(clearance[side], abs(away))
    return clearance[0], clearance[1]


def test_clearance_reaches_to_the_next_edge(variant: str) -> None:
    frame, looks = wireframe(BLOCK), camera()
    at = place_stations(frame, looks, 9.0, 3.0)
    parts = find_visible_edges(frame, looks.centre_mm)
    along = (frame.ends_mm - frame.starts_mm)[parts.edge]
    begin = frame.starts_mm[parts.edge]
    ends = [project(looks, begin + one[:, None] * along) for one in (parts.start, parts.end)]
    lines = np.column_stack(ends)
    for row in range(0, len(at.part), 7):
        assert at.clearance_px[row] == pytest.approx(nearest_px(at, lines, row), rel=1e-9)


def test_profiles_are_the_picture_between_pixels(variant: str) -> None:
    image, at = drawn(), upright()
    found = sample_profiles(image, at.uv_px, at.normal, 6)
    places = at.uv_px[:, None] + np.arange(-6, 7)[:, None] * at.normal[:, None]
    wanted = map_coordinates(image, [places[..., 1], places[..., 0]], order=1)
    known = np.isfinite(wanted)
    assert 0 < (~known).sum() < 40
    assert found[known] == pytest.approx(wanted[known], rel=1e-12)
    assert np.isnan(sample_profiles(image, np.array([[3.0, 3.0]]), at.normal[:1], 4)[0, 0])


def test_the_steepest_place_is_found(variant: str) -> None:
    image, at = drawn(), upright()
    offset, slope = search_edges(image, at, 6.0)
    known = np.isfinite(offset)
    assert offset[known] == pytest.approx(0.3, abs=0.15)
    assert (slope[known] > 15).all()
    as_by_v1(lambda: search_edges(image, at, 6.0))


@pytest.mark.parametrize("free_blur", [False, True])
def test_steps_are_measured_alike(variant: str, free_blur: bool) -> None:
    image, at = drawn(), upright()
    found = measure_steps(image, at, 1.2, free_blur)
    assert np.isnan(found.offset_px).sum() == np.isnan(found.step).sum() > 0
    assert np.nanmedian(found.offset_px) == pytest.approx(0.3, abs=0.1)
    as_by_v1(lambda: list(vars(measure_steps(image, at, 1.2, free_blur)).values()))


def test_edge_rows_are_the_same(variant: str) -> None:
    rng = np.random.default_rng(5)
    points = rng.uniform(-10, 10, (50, 3))
    normal = np.tile([0.6, 0.8], (50, 1))
    uv = project(camera(), points) + 2.5 * normal
    off, _ = residuals_with_jacobian(camera(), points, uv, normal)
    assert off == pytest.approx(2.5)
    as_by_v1(lambda: [residuals_with_jacobian(camera(), points, uv, normal)[1].ravel()])


def test_pixels_lie_across_lines(variant: str) -> None:
    rng = np.random.default_rng(6)
    start, along = rng.uniform(-10, 10, (2, 50, 3))
    share = rng.uniform(0, 1, 50)
    looks = camera()
    uv = project(looks, start + share[:, None] * along)
    off, normals, J, by_points, shares = across_lines(looks, uv, start, along, 16)
    assert off == pytest.approx(0.0, abs=1e-9)
    assert shares == pytest.approx(share, abs=1e-8)
    assert np.hypot(*normals.T) == pytest.approx(1.0)
    assert not J[:, 14:].any()
    # a line moved along itself keeps its image
    assert (by_points * along).sum(axis=1) == pytest.approx(0.0, abs=1e-8)
    aside = across_lines(looks, uv + 0.7 * normals, start, along)[0]
    assert aside == pytest.approx(0.7, abs=0.01)
    assert len(undistort_pixels(looks, uv)) == 50
    as_by_v1(lambda: [one.ravel() for one in across_lines(looks, uv + 0.7, start, along, 16)])


def alike(uv: Floats, residuals: Floats) -> float:
    """``neighbours_alike`` in plain numpy."""
    values = residuals - residuals.mean()
    total = 1.0
    for lag in range(1, 20):
        near = np.hypot(*(uv[lag:] - uv[:-lag]).T) < 2 * lag + 1
        products = (values[lag:] * values[:-lag])[near]
        if near.sum() < 30 or products.mean() < 0.05 * np.mean(values**2):
            break
        total += 2 * products.mean() / float(np.mean(values**2))
    return total


def test_neighbours_of_a_line_are_alike(variant: str) -> None:
    rng = np.random.default_rng(8)
    uv = np.column_stack([np.arange(300.0), np.linspace(0, 40, 300)])
    uv[150:] += 30
    white = rng.normal(0, 1, 300)
    smooth = np.convolve(white, np.ones(5), "same")
    assert neighbours_alike(uv, smooth) == pytest.approx(alike(uv, smooth))
    assert neighbours_alike(uv, smooth) > 3
    assert neighbours_alike(uv, white) < 1.5
    assert neighbours_alike(uv[:49], smooth[:49]) == 1.0
    assert neighbours_alike(uv, np.zeros(300)) == 1.0


@pytest.mark.parametrize("about_mean", [False, True])
def test_each_line_has_its_variance(variant: str, about_mean: bool) -> None:
    rng = np.random.default_rng(9)
    line = rng.permutation(np.repeat([7, 2, 40, 3], [200, 90, 30, 5]))
    off = rng.normal(0, 2, len(line)) + line / 4
    kept = rng.uniform(size=len(line)) < 0.9
    places = np.column_stack([np.arange(len(line)), np.zeros(len(line))]).astype(float)
    found = variances_of_lines(off, line, kept, places, about_mean, 12)
    for number in np.unique(line):
        own = (line == number) & kept
        mean = off[own].mean() if about_mean else 0.0
        wanted = max(np.mean((off[own] - mean) ** 2), 1.0)
        wanted *= alike(places[own], off[own]) if own.sum() >= 50 else 1.0
        assert found[line == number] == pytest.approx(wanted if own.sum() >= 12 else 1.0)
