"""What makes pieces a line: nothing as bright beside them, or the dark, or nearly all columns."""

import numpy as np

from crenel.metrology.stripe import LineSearch, extract_stripe, find_stripe
from crenel.metrology.stripe.line_evidence import LINE_REASONS, PIECE_REASONS, LineEvidence
from tests.present import present

HEIGHT, WIDTH = 480, 640
ON_OBJECT = slice(60, 390)


def add_line(
    light: np.ndarray, row: float, columns: slice, height: float, sigma_px: float = 2.0
) -> None:
    v = np.arange(HEIGHT)[:, None]
    light[:, columns] += height * np.exp(-0.5 * ((v - row) / sigma_px) ** 2)


def taken(light: np.ndarray) -> np.ndarray:
    noise = np.random.default_rng(1).normal(0.0, 1.5, light.shape)
    return np.clip(np.rint(light + noise), 0, 255).astype(np.uint8)


def two_lines(ground: float) -> np.ndarray:
    """The laser's line on an object, and nearly as bright on what is behind it, in short pieces."""
    light = np.full((HEIGHT, WIDTH), ground)
    add_line(light, 300.4, ON_OBJECT, 120.0)
    for begin in range(40, 600, 30):
        add_line(light, 80.2, slice(begin, begin + 20), 110.0, 4.0)
    return light


def why_of(image: np.ndarray) -> LineEvidence:
    search = LineSearch()
    return present(search.explain(image, "u", search.find(image, "u")).why)


def test_in_the_dark_other_light_of_the_laser_is_no_clutter() -> None:
    image = taken(two_lines(5.0))
    stripe = extract_stripe(image)
    assert np.abs(stripe.v - 300.4).max() < 1
    assert len(stripe.u) > 0.98 * (ON_OBJECT.stop - ON_OBJECT.start)
    assert why_of(image).decision == "in-the-dark"


def test_a_picture_that_is_as_bright_shows_none() -> None:
    image = taken(two_lines(110.0))
    assert not len(extract_stripe(image).u)
    why = why_of(image)
    assert why.decision in ("cluttered", "dim-picture")
    assert {PIECE_REASONS[reason] for reason in why.left} == {"no-line"}
    assert np.abs(why.across - 300.4).min() < 1
    assert len(why.along) == len(why.across) == len(why.left)


def test_every_point_has_what_took_it() -> None:
    light = np.full((HEIGHT, WIDTH), 10.0)
    add_line(light, 200.2, slice(0, 400), 150.0)
    add_line(light, 202.2, slice(405, 640), 25.0)
    image = taken(light)
    found, why = find_stripe(image), why_of(image)
    assert len(found.stripe.u) == len(why.taken) > 0.97 * WIDTH
    assert LINE_REASONS.index(why.decision) < LINE_REASONS.index("no-points")
    names = np.array(PIECE_REASONS)[why.taken]
    assert set(names[found.stripe.u < 395]) == {"main"}
    assert set(names[found.stripe.u > 410]) <= {"bright", "continued"}
