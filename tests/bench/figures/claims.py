"""Figures of many simulated solves: claimed uncertainty, the article's test, arms, detection."""

from collections.abc import Iterator

from tests.bench.figures.figure import Better, Command, Figure, Read
from tests.bench.figures.printed import ACCURACY, Place, in_readme
from tests.bench.figures.readings import at, over, reduced
from tests.bench.figures.tolerances import count_of, exactly, mean_of, rms_of, within

SOLVES = Command("crenel bench calibration --solves 1000")
ARTICLE = Command("crenel bench paper --arms 3")
ARMS = Command("python -m tests.bench.arms")
DETECTION = Command("crenel bench detection --seed 5000")
CLAIMED = "Claimed and observed uncertainty"
THOUSAND = rms_of(1000, "solves")
BOUND = within(0.03, "3 standard errors of 0.01, by 1000 solves")
WITHOUT_SAMPLING = within(0.015, "3 standard errors of 0.005, by 1000 solves")
SET_UPS = {
    "one pose": "one pose",
    "8 poses": "8 poses",
    "8 poses, seven axes, camera turned, no distortion": (
        "8 poses, seven axes, camera turned, no distortion"
    ),
    "8 poses, arm off by 250 µm, five faces probed": "8 poses, 250 µm arm, five faces",
    "20 poses": "20 poses",
}
CLAIMS = {
    "points": ("claimed_um", "rms_um"),
    "angle": ("angle_claimed", "angle"),
    "offset": ("offset_claimed_um", "offset_um"),
}


def over_bound(name: str, key: str = "over_bound") -> Read:
    return at("set_ups", {"name": name}, key, "value")


def claimed_over_observed(name: str, column: str) -> Read:
    claimed, observed = CLAIMS[column]
    chosen = {"name": name}
    return over(at("set_ups", chosen, claimed), at("set_ups", chosen, observed))


def claims() -> Iterator[Figure]:
    for label, name in SET_UPS.items():
        for column, key, tolerance in (
            ("rms error / Cramér-Rao bound", "over_bound", BOUND),
            ("without sampling variation", "without_sampling", WITHOUT_SAMPLING),
        ):
            place = Place(ACCURACY, CLAIMED, (label,), column)
            what, read = f"{label}: {column}", over_bound(name, key)
            yield Figure(what, SOLVES, (place,), read, Better.SMALLER, tolerance)
        for column in CLAIMS:
            place = Place(ACCURACY, CLAIMED, (label,), column)
            what = f"{label}: claimed / observed, {column}"
            read = claimed_over_observed(name, column)
            yield Figure(what, SOLVES, (place,), read, Better.NEAR_ONE, THOUSAND)


def claims_of_the_readme() -> Iterator[Figure]:
    ratios = [claimed_over_observed(name, column) for name in SET_UPS.values() for column in CLAIMS]
    errors = [over_bound(name) for name in SET_UPS.values()]
    for what, pattern, read, better, tolerance in (
        ("lowest", r"between ([\d.]+) and", reduced(min, ratios), Better.LARGER, THOUSAND),
        ("highest", r"and ([\d.]+) over", reduced(max, ratios), Better.SMALLER, THOUSAND),
        ("lowest error", r"error ([\d.]+) to", reduced(min, errors), Better.SMALLER, BOUND),
        ("highest error", r"to ([\d.]+) times", reduced(max, errors), Better.SMALLER, BOUND),
    ):
        places = (in_readme("Stated uncertainty", pattern),)
        name = f"README, stated uncertainty: {what}"
        yield Figure(name, SOLVES, places, read, better, tolerance)


def article() -> Iterator[Figure]:
    # the range of ten values scatters by 0.26 of itself
    tolerance = mean_of(3, 0.26, "arms, with ranges over ten calibrations")
    for label, better in (
        ("the article's method, one pose", Better.AS_PRINTED),
        ("joint, 8 poses", Better.SMALLER),
        ("joint, 20 poses", Better.SMALLER),
    ):
        for column, key in (
            ("range of the angle", "angle_arcsec"),
            ("range of the offset", "offset_um"),
        ):
            place = Place(ACCURACY, CLAIMED, (label,), column)
            what, read = f"{label}: {column}", at("methods", {"method": label}, key)
            yield Figure(what, ARTICLE, (place,), read, better, tolerance)


def arms() -> Iterator[Figure]:
    thirty = mean_of(30, 0.5, "arms")
    row = "Identification of the arm's own geometry"
    for name, row_of, key, pattern, better in (
        ("before", "median", "before, µm", r"from (\d+) to", Better.AS_PRINTED),
        ("after", "median", "after, µm", r"from \d+ to ([\d.]+) µm", Better.SMALLER),
    ):
        own = Place(ACCURACY, "Arm identification", pattern=pattern)
        places = (own, in_readme(row, pattern))
        what = f"identified arms, median {name}"
        yield Figure(what, ARMS, places, at(row_of, key), better, thirty)
    worst = Place(ACCURACY, "Arm identification", pattern=r"worst ([\d.]+) µm")
    read = at("worst", "after, µm")
    yield Figure("identified arms, worst", ARMS, (worst,), read, Better.SMALLER, thirty)


def detection() -> Iterator[Figure]:
    pictures = count_of(300, "pictures")
    readme = "Block detection"
    for label, key, pattern, better, tolerance in (
        ("detected", "right", r"in (\d+) of 300", Better.LARGER, pictures),
        ("refused", "refused", r"(\d+) pictures refused", Better.SMALLER, pictures),
        ("wrong detections", "wrong", "", Better.SMALLER, exactly("none is allowed")),
        ("corners, rms", "rms_px", "", Better.SMALLER, mean_of(289, 0.5, "pictures")),
        ("ratio of error", "normalised", "", Better.NEAR_ONE, mean_of(289, 0.3, "pictures")),
        (
            *("wrong certificates accepted", "wrongly_accepted", ""),
            *(Better.SMALLER, count_of(299, "certificates")),
        ),
    ):
        own = Place(ACCURACY, "Block detection", (label,))
        places = (own, in_readme(readme, pattern)) if pattern else (own,)
        what = f"block detection, {label}"
        yield Figure(what, DETECTION, places, at(key), better, tolerance)


FIGURES = (*claims(), *claims_of_the_readme(), *article(), *arms(), *detection())
