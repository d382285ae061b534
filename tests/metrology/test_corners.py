"""The object found, named and measured in pictures that the simulation renders."""

from collections.abc import Callable
from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from crenel.errors import OperationError
from crenel.metrology.detection.acceptance import is_cut_off
from crenel.metrology.detection.corner_fit import fit_corners
from crenel.metrology.detection.detect_block import ObjectDetection, detect_object
from crenel.metrology.detection.edges.measure_all import EdgeMeasurements
from crenel.metrology.detection.edges.stations import place_stations
from crenel.metrology.detection.search.line_segments import Segments
from crenel.metrology.detection.search.pose_hypotheses import pose_hypotheses
from crenel.metrology.detection.search.vanishing_points import Directions
from crenel.metrology.detection.visibility import wireframe
from crenel.metrology.image import Image
from crenel.metrology.sensor.camera import project
from crenel.metrology.stripe import extract_stripe
from crenel.metrology.targets.crenellated_block import Crenellated
from crenel.metrology.targets.crenellated_block import corners as corners_of
from crenel.metrology.transforms import Floats
from tests.metrology.refusals import refusal_of
from tests.metrology.rendered_block import RenderedBlock, render_block, survey, with_edge
from tests.pictures import blur
from tests.running.usual import usual
from tests.uncertainty_ratio import ratio_of_pulls, rows_of

pytestmark = pytest.mark.slow


def corner_errors(found: ObjectDetection, shown: RenderedBlock) -> Floats:
    """Distances (N,) in px of the corners from where the true camera has them."""
    points = corners_of(shown.block)
    true = project(shown.camera, np.array([points[corner.name] for corner in found.corners]))
    got = np.array([[corner.u, corner.v] for corner in found.corners])
    return np.asarray(np.hypot(*(got - true).T))


def refused(image: Image, block: Crenellated) -> OperationError:
    return refusal_of(detect_object, image, block)


@pytest.mark.parametrize(
    ("seed", "look"),
    usual(
        [
            (2, {}),
            (3, {"roll": 3.0, "merlons": 3}),
            (4, {"roll": 1.3, "azimuth": -0.5, "merlons": 5}),
            (5, {"roll": -0.6, "azimuth": 0.45, "elevation": 0.75}),
            (6, {"fill": 0.4, "table": 0.3, "elevation": 1.1}),
            (7, {"table": 1.3, "shade": 0.7}),
            (8, {"merlons": 6, "azimuth": -0.2, "shade": 0.0}),
        ],
        {1, 3, 4},
        pytest.mark.soak,
    ),
)
def test_any_block_from_any_side(seed: int, look: dict[str, Any]) -> None:
    shown = render_block(seed, **look)
    found = detect_object(shown.image, shown.block)
    errors = corner_errors(found, shown)
    assert len(errors) >= 10
    # The certificate alone is 2 µm, some 0.04 px, a coordinate off.
    assert np.median(errors) < 0.25
    assert errors.max() < 1.5


def test_a_block_known_by_its_drawing_is_found_as_made(plain: RenderedBlock) -> None:
    rng = np.random.default_rng(3)
    off_mm = rng.uniform(-0.1, 0.1, len(plain.block.edges_x_mm))
    drawn = replace(
        plain.block,
        edges_x_mm=tuple(float(x) for x in plain.block.edges_x_mm + off_mm),
        crest_z_mm=plain.block.crest_z_mm + 0.08,
        standard_uncertainty_mm=0.1 / np.sqrt(3),
        is_nominal=True,
    )
    errors = corner_errors(detect_object(plain.image, drawn), plain)
    assert len(errors) >= 10
    assert np.median(errors) < 0.25
    certified = replace(drawn, standard_uncertainty_mm=0.002, is_nominal=False)
    assert refused(plain.image, certified).code == "object-does-not-match"


def test_the_stripe_over_the_edges_is_left_out(plain: RenderedBlock) -> None:
    lit = render_block(1, merlons=4, laser=0.9)
    stripe = extract_stripe(lit.image)
    found = detect_object(lit.image, lit.block, stripe)
    assert np.median(corner_errors(found, lit)) < 0.25
    points = np.vstack([edge.uv_px for edge in found.edges])
    on_stripe = np.interp(points[:, 0], stripe.u, stripe.v, left=-99, right=-99)
    covered = np.interp(points[:, 0], stripe.u, np.arange(len(stripe.u)), left=-99, right=-99)
    nearest = np.abs(stripe.u[np.clip(np.rint(covered).astype(int), 0, len(stripe.u) - 1)])
    beside = np.abs(nearest - points[:, 0]) < 1.0
    assert np.abs(points[beside, 1] - on_stripe[beside]).min() > 2.0


def test_deviations_of_edge_points_are_those_of_their_scatter(plain: RenderedBlock) -> None:
    found = detect_object(plain.image, plain.block)
    at = place_stations(wireframe(plain.block), found.camera, 1.0, 0.0)
    names = np.array(wireframe(plain.block).names)
    z = []
    for edge in found.edges:
        line = at.uv_px[names[at.edge] == edge.edge]
        nearest = np.argmin(((edge.uv_px[:, None] - line) ** 2).sum(axis=2), axis=1)
        off = ((edge.uv_px - line[nearest]) * edge.normal).sum(axis=1)
        if len(off) >= 20:
            z.append((off - off.mean()) / edge.sigma_px)
    ratio_of_pulls(rows_of(np.concatenate(z), 10)).assert_within()


def test_corner_covariances_hold(plain: RenderedBlock) -> None:
    found = detect_object(plain.image, plain.block)
    points = corners_of(plain.block)
    true = project(plain.camera, np.array([points[c.name] for c in found.corners]))
    mm_per_px = 135.0 / plain.camera.matrix[0, 0]
    made = (plain.block.standard_uncertainty_mm / mm_per_px) ** 2 * np.eye(2)
    squares = [
        (np.array([c.u, c.v]) - at) @ np.linalg.inv(c.covariance_px2 + made) @ ([c.u, c.v] - at)
        for c, at in zip(found.corners, true, strict=True)
    ]
    assert np.median(squares) < 4.0


def test_a_mirrored_picture_is_refused(plain: RenderedBlock) -> None:
    """Flipped upside down: turned by 180°, that is the picture flipped sideways."""
    refusal = refused(np.ascontiguousarray(plain.image[::-1]), plain.block)
    assert refusal.code == "object-mirrored"
    assert "mirror" in refusal.line


@pytest.mark.soak
def test_a_mirrored_certificate_is_refused(plain: RenderedBlock) -> None:
    edges = tuple(-x for x in reversed(plain.block.edges_x_mm))
    refusal = refused(plain.image, replace(plain.block, edges_x_mm=edges))
    assert refusal.code == "object-mirrored"


# Outer and inner edges, each by little and by much.
@pytest.mark.parametrize(
    ("edge", "by_mm"), usual([(0, 0.15), (7, 1.0), (3, 1.0), (4, 0.15)], {0, 2}, pytest.mark.soak)
)
def test_one_edge_of_other_size_is_refused(plain: RenderedBlock, edge: int, by_mm: float) -> None:
    refusal = refused(plain.image, with_edge(plain.block, edge, by_mm))
    assert refusal.code == "object-does-not-match"
    assert plain.block.name in str(refusal.what)


def test_another_block_is_refused(plain: RenderedBlock) -> None:
    assert refused(plain.image, render_block(9).block).code == "object-does-not-match"


def test_a_longer_block_that_begins_alike_is_refused(plain: RenderedBlock) -> None:
    shorter = replace(plain.block, edges_x_mm=plain.block.edges_x_mm[:-2])
    assert refused(plain.image, shorter).code == "object-does-not-match"


def test_a_block_that_reads_alike_both_ways_is_refused(plain: RenderedBlock) -> None:
    edges = (-20.0, -12.0, -5.0, 5.0, 12.0, 20.0)
    shown = render_block(2)
    code = refused(shown.image, replace(shown.block, edges_x_mm=edges)).code
    assert code in ("object-ambiguous", "object-does-not-match")


def test_pictures_without_a_block(plain: RenderedBlock) -> None:
    rng = np.random.default_rng(1)
    noise = rng.integers(20, 200, plain.image.shape).astype(np.uint8)
    assert refused(noise, plain.block).code == "object-not-found"
    assert refused(np.zeros(plain.image.shape, np.uint8), plain.block).code == "image-dark"


def with_noise(image: NDArray[np.uint8]) -> Image:
    noise = np.random.default_rng(3).normal(0, 10, image.shape)
    return np.clip(image + noise, 0, 255).astype(np.uint8)


@pytest.mark.parametrize(
    ("changed", "most_px"),
    [
        (with_noise, 0.6),
        (lambda image: blur(image, 1.5), 0.5),
        (lambda image: image.astype(np.uint16) * 16, 0.25),
    ],
    ids=["noisy", "soft", "twelve bits"],
)
def test_lesser_pictures_are_measured(
    plain: RenderedBlock, changed: Callable[[NDArray[np.uint8]], Image], most_px: float
) -> None:
    found = detect_object(changed(plain.image), plain.block)
    assert np.median(corner_errors(found, plain)) < most_px


def test_edges_of_a_few_long_pieces_make_corners(plain: RenderedBlock) -> None:
    """As in noise: what each piece gathers is worth many, but short edges have few of them."""
    found = survey(plain)
    at, used, length = found.at, found.used.copy(), found.at.length_px.copy()
    fronts = [k for k, name in enumerate(found.frame.names) if name.startswith("crest:1:front")]
    rows = np.flatnonzero(used & np.isin(at.edge, fronts))
    middle = rows[len(rows) // 2]
    used[rows], used[middle], length[middle] = False, True, length[rows].sum()
    few = replace(found, at=replace(at, length_px=length), used=used)
    corners = {corner.name: corner for corner in fit_corners(few)}
    for name in ("crest:1:L:front", "crest:1:R:front"):
        true = project(plain.camera, corners_of(plain.block)[name][None])[0]
        corner = corners[name]
        off = np.array([corner.u, corner.v]) - true
        assert off @ np.linalg.solve(corner.covariance_px2 + 0.05**2 * np.eye(2), off) < 12.0


def test_a_block_half_out_of_the_picture_is_refused(plain: RenderedBlock) -> None:
    shown = np.ascontiguousarray(plain.image[:, : plain.image.shape[1] // 3])
    code = refused(shown, plain.block).code
    assert code in ("object-cut-off", "object-does-not-match")


def test_a_cut_off_block_needs_a_level_below_its_crests(plain: RenderedBlock) -> None:
    found = survey(plain)

    def without(*kinds: str) -> EdgeMeasurements:
        names = np.array(found.frame.names)[found.at.edge]
        left_out = np.array([name.startswith(kinds) for name in names])
        return replace(found, used=found.used & ~left_out)

    assert not is_cut_off(without("floor"), plain.block, 0.8)
    assert is_cut_off(without("floor", "base"), plain.block, 0.8)


def test_directions_that_no_segment_follows_place_nothing(plain: RenderedBlock) -> None:
    lines = np.array([[10.0, 10.0, 90.0, 20.0], [30.0, 80.0, 70.0, 15.0]])
    nobody = Directions(np.eye(3), 1.5, np.array([-1, -1]), 0.0)
    assert pose_hypotheses(nobody, Segments(lines, np.ones(2)), plain.block) == []
