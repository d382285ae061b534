"""Figures of many simulated solves: claimed uncertainty, the article's test, arms, detection."""

from collections.abc import Iterator

from tests.bench.figures.figure import Command, Figure
from tests.bench.figures.printed import in_readme
from tests.bench.figures.readings import at, over, reduced
from tests.bench.figures.section import AS_PRINTED, LARGER, NEAR_ONE, SMALLER, Section
from tests.bench.figures.tolerances import count_of, exactly, mean_of, rms_of, within

SOLVES = Command("python -m tests.bench calibration --solves 1000")
ARTICLE = Command("python -m tests.bench paper --arms 3")
ARMS = Command("python -m tests.bench arms")
DRAWINGS = Command("python -m tests.bench nominal-block --solves 60 --sessions 0")
CERTIFICATES = Command("python -m tests.bench block-certificate")
DETECTION = Command("python -m tests.bench detection --seed 5000")
CLAIMED = "Claimed and observed uncertainty"
THOUSAND = rms_of(1000, "solves")
BOUND = within(0.03, "3 standard errors of 0.01, by 1000 solves")
WITHOUT_SAMPLING = within(0.015, "3 standard errors of 0.005, by 1000 solves")
NAMES = (
    "one pose",
    "8 poses",
    "8 poses, seven axes, camera turned, no distortion",
    "8 poses, 250 µm arm, five faces",
    "20 poses",
)
LABELS = {"8 poses, 250 µm arm, five faces": "8 poses, arm off by 250 µm, five faces probed"}
"""Of names that the page words otherwise."""


def claims() -> Iterator[Figure]:
    figure = Section(SOLVES, CLAIMED)
    errors, ratios = [], []
    for name in NAMES:
        label, of_set_up = LABELS.get(name, name), ("set_ups", {"name": name})
        errors.append(at(*of_set_up, "over_bound", "value"))
        for column, key, tolerance in (
            ("rms error / Cramér-Rao bound", "over_bound", BOUND),
            ("without sampling variation", "without_sampling", WITHOUT_SAMPLING),
        ):
            read = at(*of_set_up, key, "value")
            yield figure(f"{label}: {column}", (label, column), read, SMALLER, tolerance)
        for column, claimed, observed in (
            ("points", "claimed_um", "rms_um"),
            ("angle", "angle_claimed", "angle"),
            ("offset", "offset_claimed_um", "offset_um"),
        ):
            what = f"{label}: claimed / observed, {column}"
            ratios.append(read := over(at(*of_set_up, claimed), at(*of_set_up, observed)))
            yield figure(what, (label, column), read, NEAR_ONE, THOUSAND)
    for what, pattern, read, better, tolerance in (
        ("lowest", r"between ([\d.]+) and", reduced(min, ratios), LARGER, THOUSAND),
        ("highest", r"and ([\d.]+) over", reduced(max, ratios), SMALLER, THOUSAND),
        ("lowest error", r"error ([\d.]+) to", reduced(min, errors), SMALLER, BOUND),
        ("highest error", r"to ([\d.]+) times", reduced(max, errors), SMALLER, BOUND),
    ):
        place = in_readme("Stated uncertainty", pattern)
        yield figure(f"README, stated uncertainty: {what}", place, read, better, tolerance)


def article() -> Iterator[Figure]:
    figure = Section(ARTICLE, CLAIMED)
    # the range of ten values scatters by 0.26 of itself
    tolerance = mean_of(3, 0.26, "arms, with ranges over ten calibrations")
    for label, better in (
        ("the article's method, one pose", AS_PRINTED),
        ("joint, 8 poses", SMALLER),
        ("joint, 20 poses", SMALLER),
    ):
        for quantity, key in (("angle", "angle_arcsec"), ("offset", "offset_um")):
            column, read = f"range of the {quantity}", at("methods", {"method": label}, key)
            yield figure(f"{label}: {column}", (label, column), read, better, tolerance)


def arms() -> Iterator[Figure]:
    figure, thirty = Section(ARMS, "Arm identification"), mean_of(30, 0.5, "arms")
    row = "Identification of the arm's own geometry"
    for what, pattern, read, better in (
        ("median before", r"from (\d+) to", at("median", "before, µm"), AS_PRINTED),
        ("median after", r"from \d+ to ([\d.]+) µm", at("median", "after, µm"), SMALLER),
        ("worst", r"worst ([\d.]+) µm", at("worst", "after, µm"), SMALLER),
    ):
        also = None if what == "worst" else in_readme(row, pattern)
        yield figure(f"identified arms, {what}", pattern, read, better, thirty, also)


def detection() -> Iterator[Figure]:
    figure, certificates = Section(DETECTION, "Block detection"), count_of(299, "certificates")
    pictures = count_of(300, "pictures")
    for label, key, pattern, better, tolerance in (
        ("detected", "right", r"in (\d+) of 300", LARGER, pictures),
        ("refused", "refused", r"(\d+) pictures refused", SMALLER, pictures),
        ("wrong detections", "wrong", "", SMALLER, exactly("none is allowed")),
        ("corners, rms", "rms_px", "", SMALLER, mean_of(289, 0.5, "pictures")),
        ("ratio of error", "normalised", "", NEAR_ONE, mean_of(289, 0.3, "pictures")),
        ("wrong certificates accepted", "wrongly_accepted", "", SMALLER, certificates),
    ):
        also = in_readme("Block detection", pattern) if pattern else None
        what = f"block detection, {label}"
        yield figure(what, (label, 1), at(key), better, tolerance, also)


def drawings() -> Iterator[Figure]:
    figure = Section(DRAWINGS, "A block known by its drawing")
    sixty = rms_of(60, "solves")
    for label, name in (("three faces touched", "3 faces"), ("five faces touched", "5 faces")):
        found, drawn = f"{name}, edges estimated", f"{name}, drawing as certificate"
        for column, row, key, better in (
            ("a point, edges estimated", found, "point, rms µm", SMALLER),
            ("drawing as certificate", drawn, "point, rms µm", AS_PRINTED),
            ("claimed / observed, point", found, "claimed / observed", NEAR_ONE),
            ("edges, rms", found, "edges, rms µm", SMALLER),
            ("claimed / observed, edges", found, "edges, claimed / obs.", NEAR_ONE),
        ):
            yield figure(f"{label}: {column}", (label, column), at(row, key), better, sixty)


def certificates() -> Iterator[Figure]:
    figure, fifty = (
        Section(CERTIFICATES, "A block's certificate by an arm's tip"),
        rms_of(50, "blocks"),
    )
    for label, row in (
        ("all 50", "all blocks"),
        ("tip certified", "tip certified"),
        ("tip unknown, one width by micrometer", "tip unknown, width by micrometer"),
    ):
        for column, key, better in (
            ("edges, rms", "edges, rms µm", SMALLER),
            ("claimed / observed", "claimed / observed", NEAR_ONE),
        ):
            what = f"certificate by tip, {label}: {column}"
            yield figure(what, (label, column), at(row, key), better, fifty)
    read = at("exchanged touches", "named")
    tolerance = count_of(50, "blocks")
    yield figure("exchanged touches named", r"named in (\d+) of 50", read, LARGER, tolerance)


FIGURES = (*claims(), *drawings(), *certificates(), *article(), *arms(), *detection())
