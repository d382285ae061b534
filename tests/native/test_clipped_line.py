"""A line whose core is clipped: its stages in C beside plain numpy, alike in every variant."""

import numpy as np
import pytest
from numpy.typing import NDArray

from crenel.metrology.image import Image, saturation_level
from crenel.metrology.stripe import StripeTracker, extract_stripe
from crenel.metrology.stripe.workspace import Fields, Workspace
from crenel.native.arguments import I32, Array, Function, Real, Record
from crenel.native.library import CRENEL

KINDS = [np.uint8, np.uint16]
BREAK, NARROWEST, WIDEST = 2, 5, 64
HEIGHT, WIDTH = 300, 645
U, V = np.arange(WIDTH), np.arange(HEIGHT)[:, None]
CENTRE = 140 + 30 * np.sin(U / 90)


def lit_image(light: NDArray[np.float64], kind: type, seed: int = 0) -> Image:
    """What a sensor of 8 or of 12 bits makes of light."""
    noise = np.random.default_rng(seed).normal(size=light.shape) * np.sqrt(4 + 0.1 * light)
    levels = (8 + light + noise) * (1 if kind == np.uint8 else 16)
    return np.clip(np.rint(levels), 0, 255 if kind == np.uint8 else 4095).astype(kind)


def beam(row: NDArray[np.float64], height: NDArray[np.float64] | float) -> NDArray[np.float64]:
    return np.asarray(height * np.exp(-0.5 * ((V - row) / 2.5) ** 2))


def found_cores(image: Image, where: NDArray[np.bool_] | None = None) -> NDArray[np.int32]:
    """(3, n) columns, first and last rows."""
    workspace = Workspace(((image.shape[0], image.shape[1]), image.dtype))
    parts, known = np.array([[0, image.shape[0], 0, image.shape[1]]]), np.zeros(4, np.float32)
    workspace.set_frame(image, parts, where, known)
    find = Function(
        CRENEL,
        f"find_cores_{8 * image.itemsize}",
        Record(Fields),
        Real(),
        Array(I32, 3, "width", written=True),
        returns=int,
    )
    cores = np.zeros((3, image.shape[1]), np.int32)
    count = find(workspace.fields, saturation_level(image), cores)
    return cores[:, :count]


def cores_of(image: Image) -> NDArray[np.int32]:
    """The same by numpy, for columns that hold one run each."""
    cores = []
    for column in range(image.shape[1]):
        rows = np.flatnonzero(image[:, column] >= saturation_level(image))
        if len(rows):
            first, last = rows[0], rows[-1]
            assert np.max(np.diff(rows), initial=0) <= BREAK + 1
            if NARROWEST <= last - first + 1 <= WIDEST:
                cores.append((column, first, last))
    return np.array(cores, np.int32).T


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("variant", CRENEL.variants)
def test_the_core_is_where_its_pixels_are_clipped(variant: str, kind: type) -> None:
    image = lit_image(beam(CENTRE, 900.0), kind)
    expected = cores_of(image)
    assert expected.shape[1] == WIDTH
    with CRENEL.using(variant):
        assert np.array_equal(found_cores(image), expected)


@pytest.mark.parametrize("kind", KINDS)
def test_of_two_cores_the_one_of_the_longer_track_counts(kind: type) -> None:
    shorter = np.where((U > 200) & (U < 420), 900.0, 0.0)
    image = lit_image(beam(CENTRE, 900.0) + beam(CENTRE - 80, shorter), kind)
    assert np.array_equal(found_cores(image), cores_of(lit_image(beam(CENTRE, 900.0), kind)))


def test_cores_outside_the_mask_count_for_nothing() -> None:
    patch = np.where((U > 200) & (U < 420), 900.0, 60.0)
    image = lit_image(beam(CENTRE, patch) + beam(CENTRE - 80, 900.0), np.uint8)
    cores = found_cores(image, np.abs(V - CENTRE) < 30)
    assert np.array_equal(cores[0], np.arange(201, 420))
    assert np.max(np.abs((cores[1] + cores[2]) / 2 - CENTRE[201:420])) < 2


def test_a_spot_and_hot_pixels_are_no_core() -> None:
    image = lit_image(beam(CENTRE, 100.0), np.uint8)
    image[30:42, 300:312] = 255
    image[np.random.default_rng(1).random(image.shape) < 1e-4] = 255
    assert found_cores(image).shape[1] == 0


@pytest.mark.parametrize("width", [NARROWEST - 1, NARROWEST, WIDEST, WIDEST + 1])
def test_a_core_has_a_least_and_a_greatest_width(width: int) -> None:
    image = np.zeros((HEIGHT, WIDTH), np.uint8)
    image[100 : 100 + width] = 255
    wide_enough = NARROWEST <= width <= WIDEST
    assert found_cores(image).shape[1] == (WIDTH if wide_enough else 0)


def test_a_few_pixels_that_are_not_clipped_break_no_core() -> None:
    image = np.zeros((HEIGHT, WIDTH), np.uint8)
    image[100:120] = 255
    for hole in (BREAK, BREAK + 1):
        image[107 : 107 + hole] = 200
        cores = found_cores(image)
        assert cores[:, 0].tolist() == ([0, 100, 119] if hole == BREAK else [0, 100, 106])


def mixed_image(kind: type, row: float = 0.0) -> Image:
    """A line that is clipped in a patch, with a highlight beside it."""
    height = 110 + 1500 * np.exp(-0.5 * ((U - 300) / 60) ** 2)
    around = np.hypot(U - 560, 0.7 * (V - 250))
    highlight = 2000 * np.exp(-0.5 * ((around - 30) / 4) ** 2)
    return lit_image(beam(CENTRE + row, height) + highlight, kind)


@pytest.mark.parametrize("kind", KINDS)
def test_every_variant_gives_exactly_the_same_points(kind: type) -> None:
    images = [mixed_image(kind), lit_image(beam(CENTRE, 1500.0), kind)]
    with CRENEL.using("v1"):
        reference = [extract_stripe(image) for image in images]
    for variant in CRENEL.variants:
        with CRENEL.using(variant):
            for image, expected in zip(images, reference, strict=True):
                found = extract_stripe(image)
                assert len(found.u) > 0.95 * WIDTH
                assert np.array_equal(found.uv_px, expected.uv_px)
                assert np.array_equal(found.sigma_px, expected.sigma_px)


@pytest.mark.parametrize("kind", KINDS)
def test_a_clipped_line_that_is_followed_lies_where_the_whole_image_shows_it(kind: type) -> None:
    tracker = StripeTracker()
    for number in range(8):
        image = mixed_image(kind, 3.0 * number)
        found, whole = tracker.extract(image), extract_stripe(image)
        column = found.u.astype(int)
        clipped = (column > 230) & (column < 370)
        assert clipped.sum() == 139
        assert np.abs((found.v - CENTRE[column] - 3 * number)[clipped]).max() < 0.1
        both = np.intersect1d(found.u, whole.u)
        one = found.v[np.isin(found.u, both)] - whole.v[np.isin(whole.u, both)]
        assert np.max(np.abs(one[both < 500])) < 0.02


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("row", [4.0, HEIGHT - 6.0])
def test_a_clipped_line_along_the_border_is_placed_where_it_shows(kind: type, row: float) -> None:
    towards = 0.06 * U if row < HEIGHT / 2 else -0.06 * U
    centre = np.asarray(row + towards, dtype=np.float64)
    found = extract_stripe(lit_image(beam(centre, 1500.0), kind))
    error = found.v - centre[found.u.astype(int)]
    inside = np.abs(centre[found.u.astype(int)] - HEIGHT / 2) < HEIGHT / 2 - 14
    assert inside.sum() > 0.6 * WIDTH
    assert np.sqrt(np.mean(error[inside] ** 2)) < 0.03
