"""Figures of stripe extraction and of smoothing along the line."""

from collections.abc import Iterator

from tests.bench.figures.figure import Command, Figure, Read
from tests.bench.figures.printed import Quotient, in_readme
from tests.bench.figures.readings import at, over, percent
from tests.bench.figures.section import AS_PRINTED, LARGER, NEAR_ONE, SMALLER, Section
from tests.bench.figures.tolerances import count_of, exactly, rms_of, speed

EXTRACTION = Section(Command("python -m tests.bench extraction"), "Stripe extraction")
CLIPPED = Section(Command("python -m tests.bench extraction --clipped"), "Stripe extraction")
SMOOTHING = Section(Command("python -m tests.bench smoothing"), "Smoothing along the line")
README_ROW = "Stripe extraction"
CRENEL, OPENCV, NUMPY = "Crenel", "OpenCV Gauss + parabola", "numpy argmax + centroid"
POINTS = 15_000
"""Of twelve frames of 1280 columns with gaps."""
KINDS = {"plain": POINTS, "speckle": POINTS // 4, "speckle, round grains": POINTS // 8}
"""Points with noise of their own: neighbours of a speckled line err alike."""


def measure(name: str, method: str = "crenel") -> Read:
    return at("measures", {"measure": name}, method)


def rates() -> Iterator[Figure]:
    """Over those of the peers: an absolute rate says what the machine is."""
    row, extraction = "whole frames per second", measure("whole-frame extraction")
    own, readme = EXTRACTION.place(row, CRENEL), in_readme(README_ROW, r"([\d ]+) frames of")
    followed = measure("with the stripe followed")
    for column, key in ((OPENCV, "opencv"), (NUMPY, "centroid")):
        peer = EXTRACTION.place(row, column)
        read = over(extraction, measure("whole-frame extraction", key))
        places = (Quotient(own, peer), Quotient(readme, peer))
        what = f"extraction, rate over {column}"
        yield Figure(what, EXTRACTION.command, places, read, LARGER, speed())
    tracking = EXTRACTION.place("frames per second with stripe tracking", CRENEL)
    what = "extraction, rate with tracking over that of whole frames"
    yield EXTRACTION(what, Quotient(tracking, own), over(followed, extraction), LARGER, speed())
    for which, width in enumerate((20, 50)):
        what = f"extraction, rate with a line {width} px wide over a narrow one"
        read = over(measure(f"the same, {width} px wide at half height"), followed)
        place = ("the same with a line 20 px", CRENEL, which)
        yield EXTRACTION(what, place, read, LARGER, speed())


def errors() -> Iterator[Figure]:
    bound, speckled = "rms error / Cramér-Rao bound", "the same with speckle; with round grains"
    readme = in_readme(README_ROW, r"error ([\d.]+) times")
    for number, (kind, points) in enumerate(KINDS.items()):
        tolerance = rms_of(points, "points")
        for column, key, better in (
            (CRENEL, "crenel", SMALLER),
            (OPENCV, "opencv", AS_PRINTED),
            (NUMPY, "centroid", AS_PRINTED),
        ):
            place = (speckled if number else bound, column, 1 if number == 2 else 0)
            what, read = f"error / bound, {kind}", measure(f"rms error / bound, {kind}", key)
            also = readme if kind == "plain" and column == CRENEL else None
            yield EXTRACTION(f"extraction, {what}: {column}", place, read, better, tolerance, also)
        what, place = f"error / stated deviation, {kind}", ("rms of error / stated", CRENEL, number)
        read = measure(f"rms of {what}")
        yield EXTRACTION(f"extraction, {what}", place, read, NEAR_ONE, tolerance)


def nuisances() -> Iterator[Figure]:
    false = "false points a frame, a reflection, a lamp's spot, 60 hot pixels"
    columns = count_of(POINTS, "columns", 100 / POINTS)
    for what, label, name, tolerance in (
        ("false points per frame", "false points per frame", false, exactly("none is allowed")),
        ("missed columns, %", "missed columns", "missed columns, the same", columns),
        ("saturated", "saturated patch", "saturated patch, rms", rms_of(200, "independent points")),
    ):
        read = measure(name)
        yield EXTRACTION(f"extraction, {what}", (label, CRENEL), read, SMALLER, tolerance)


def clipped() -> Iterator[Figure]:
    independent = rms_of(200, "independent points")
    spot, *of_the_line = (
        "a spot of 12 × 12 pixels",
        "80 columns of the line",
        "half of the line",
        "all of the line",
    )
    broken = tuple(f"{columns} columns of a broken line" for columns in (30, 40, 80, 480))
    for kind in (spot, *of_the_line, *broken):
        share = r"(\d+) %" if kind in broken else r"\((\d+) %\)"
        for bits in (8, 16):
            for how, key in (("", "full_search_share"), (", tracked", "followed_share")):
                place = CLIPPED.place(kind, f"{bits} bit{how}", pattern=share)
                read = percent(at("kinds", {"kind": kind, "bits": bits}, key))
                what = f"clipped, {kind}, {bits} bit{how}: rate over plain, %"
                yield CLIPPED(what, place, read, LARGER, speed())
    for kind in (*of_the_line, *broken):
        where = (kind, "rms error, clipped columns")
        read = at("kinds", {"kind": kind, "bits": 8}, "error_px")
        yield CLIPPED(f"clipped, {kind}: error", where, read, SMALLER, independent)


def smoothing() -> Iterator[Figure]:
    kinds = {kind: points * 16 // 12 for kind, points in KINDS.items()}
    for kind, points in (kinds | {"a saturated patch": 16 * 100}).items():
        name = kind.removeprefix("a ")
        for px in (0, 1, 2, 5, 10):
            # a line smoothed by s pixels has a point of its own every 3.5 s columns
            own = rms_of(round(points / max(1.0, 3.5 * px)), "independent points")
            for row, key, better in (
                ("noise", "noise, px", SMALLER),
                ("claimed / observed", "claimed / observed", NEAR_ONE),
            ):
                place = (f"{kind}: {row}", f"{px} px" if px else "none")
                what, read = f"smoothed by {px} px, {name}: {row}", at(f"{name}: {key}", f"{px} px")
                yield SMOOTHING(what, place, read, better, own)


FIGURES = (*rates(), *errors(), *nuisances(), *clipped(), *smoothing())
