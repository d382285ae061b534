"""Stages of the stripe's extraction in C say the same as numpy, in every variant."""

import ctypes

import numpy as np
import pytest
from numpy.typing import NDArray

from crenel.metrology.image import Image
from crenel.metrology.stripe import Stripe, StripeTracker, extract_stripe
from crenel.metrology.stripe.workspace import BLOCK, PROFILE_ROWS, Fields, Workspace
from crenel.native.arguments import F32, I32, Array, Function, Integer, Record
from crenel.native.library import CRENEL
from tests.pictures import Depth, of_depth
from tests.running.usual import usual

KINDS = [np.uint8, np.uint16]
STEP, STRIP, AWAY = 2, 8, 6
REACH = 7
HEIGHT, WIDTH = 60, 150


KEPT: list[object] = []
"""Arrays that workspaces point to."""


def workspace_for(image: Image, where: NDArray[np.bool_] | None = None) -> Workspace:
    """A workspace that points to a whole image."""
    parts, known = np.array([[0, image.shape[0], 0, image.shape[1]]]), np.zeros(4, np.float32)
    KEPT[:] = [image, where, parts, known]
    workspace = Workspace(((image.shape[0], image.shape[1]), image.dtype))
    workspace.set_frame(image, parts, where, known)
    return workspace


def test_both_sides_agree_on_the_workspace(variant: str) -> None:
    assert Function(CRENEL, "workspace_bytes", returns=int)() == ctypes.sizeof(Fields)


def scores(image: Image, where: NDArray[np.bool_] | None) -> NDArray[np.int64]:
    """(cores, W) how far each core stands out of the brighter of its surroundings."""
    wide = image.astype(np.int64)
    mean = (wide[:-2] + wide[2:] + 1) // 2
    core = np.minimum(mean[:-1], mean[1:])[::STEP]
    core = core[: len(core) // 2 * 2]
    count = len(core)
    even = np.arange(count) // 2 * 2
    odd = np.arange(count) % 2
    above = np.where(even >= AWAY, even - AWAY, even + AWAY)
    below = np.where(even + AWAY < count, even + AWAY, above)
    around = np.maximum(core[above + odd], core[below + odd])
    allowed = True if where is None else where[np.arange(count) * STEP + 1]
    return np.asarray(np.maximum(np.where(allowed, core, 0) - around, 0))


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize(
    ("height", "width"),
    usual([(40, 1), (47, 64), (48, 200), (61, 63), (100, 65)], 3, pytest.mark.soak),
)
@pytest.mark.parametrize("masked", [False, True])
def test_a_strip_keeps_its_highest_score(
    variant: str, kind: Depth, height: int, width: int, masked: bool
) -> None:
    shape, rng = (height, width), np.random.default_rng(width)
    image = of_depth(rng.integers(0, np.iinfo(kind).max, shape, endpoint=True), kind)
    where = rng.random(shape) < 0.7 if masked else None
    workspace = workspace_for(image, where)
    search = Function(CRENEL, f"search_{8 * image.itemsize}", Record(Fields), returns=int)
    highest = search(workspace.fields)
    expected = scores(image, where)
    whole = np.zeros((-(-len(expected) // STRIP) * STRIP, shape[1]), np.int64)
    whole[: len(expected)] = expected
    strips = whole.reshape(-1, STRIP, shape[1])
    score, place = workspace.view("score", kind), workspace.view("place", np.uint8)
    best = strips.max(axis=1)
    assert np.array_equal(score[1 : len(best) + 1, : shape[1]], best)
    assert not score[0].any()
    assert not score[len(best) + 1 :].any()
    lit = best > 0
    assert np.array_equal(place[1 : len(best) + 1, : shape[1]][lit], strips.argmax(axis=1)[lit])
    assert 0 < highest <= np.iinfo(kind).max


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize(
    ("columns", "rows"),
    [
        pytest.param(np.arange(64) + 5, np.full(64, 30), id="level"),
        pytest.param(np.arange(64) + 5, 30 + np.arange(64) % 5, id="jagged"),
        pytest.param(np.arange(64) + 86, 15 + np.arange(64) // 2, id="sloped"),
        pytest.param(np.arange(64) + 5, 30 + 13 * (np.arange(64) % 2), id="apart"),
        pytest.param(
            np.arange(64) + 5, 15 + np.random.default_rng(2).permutation(64) % 30, id="all-ways"
        ),
        pytest.param(np.arange(64) + 5, 8 + 35 * (np.arange(64) % 2), id="too-far"),
        pytest.param(2 * np.arange(64) + 5, 30 + np.arange(64) % 3, id="every-other"),
        pytest.param(np.arange(40) + 20, 25 + np.arange(40) % 3, id="not-full"),
        pytest.param(np.arange(64) + 5, np.arange(64) % HEIGHT, id="over-the-border"),
    ],
)
def test_each_lane_holds_the_pixels_about_its_peak(
    variant: str, kind: Depth, columns: NDArray[np.int64], rows: NDArray[np.int64]
) -> None:
    rng = np.random.default_rng(1)
    image = of_depth(rng.integers(0, np.iinfo(kind).max, (HEIGHT, WIDTH)), kind)
    profile = np.full((PROFILE_ROWS, BLOCK), -1, np.float32)
    gather = Function(
        CRENEL,
        f"gather_{8 * image.itemsize}",
        Array(I32, "n"),
        Array(I32, "n"),
        Record(Fields),
        Integer(),
        Array(F32, PROFILE_ROWS, BLOCK, written=True),
    )
    places = columns.astype(np.int32), rows.astype(np.int32)
    gather(*places, workspace_for(image).fields, REACH, profile)
    lane = np.minimum(np.arange(BLOCK), len(columns) - 1)
    seen = np.clip(rows[lane] + np.arange(-REACH, REACH + 1)[:, None], 0, HEIGHT - 1)
    assert np.array_equal(profile[: 2 * REACH + 1], image[seen, columns[lane]])


def line_image(kind: type, row: float) -> Image:
    """A noisy, bent line with a ghost, a gap and a jump."""
    rng = np.random.default_rng(7)
    u, v = np.arange(700), np.arange(400)[:, None]
    centre = row + 40 * np.sin(u / 90) + 30 * (u > 450)
    height = np.where((u > 200) & (u < 230), 0, 110 + 50 * np.cos(u / 33))
    light = height * np.exp(-0.5 * ((v - centre) / (1.4 + u / 500)) ** 2)
    light += 0.3 * height * np.exp(-0.5 * ((v - centre - 70) / 1.5) ** 2)
    noisy = 8 + light + rng.normal(size=light.shape) * np.sqrt(2 + 0.05 * light)
    return np.clip(np.rint(noisy * (1 if kind == np.uint8 else 16)), 0, 250 * 16).astype(kind)


def followed(kind: type) -> list[Stripe]:
    """One image by itself, then frames that follow one another."""
    tracker = StripeTracker()
    frames = [tracker.extract(line_image(kind, 120 + 4 * i)) for i in range(6)]
    return [extract_stripe(line_image(kind, 120.0)), *frames]


@pytest.mark.parametrize("kind", KINDS)
def test_every_variant_gives_exactly_the_same_points(kind: type) -> None:
    found = {}
    for variant in CRENEL.variants:
        with CRENEL.using(variant):
            found[variant] = followed(kind)
    for stripes in found.values():
        for one, reference in zip(stripes, found["v1"], strict=True):
            assert len(one.u) > 550
            assert np.array_equal(one.uv_px, reference.uv_px)
            assert np.array_equal(one.sigma_px, reference.sigma_px)
