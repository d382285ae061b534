"""Figures of stripe extraction and of smoothing along the line."""

from collections.abc import Iterator

from tests.bench.figures.figure import Better, Command, Figure, Read
from tests.bench.figures.printed import ACCURACY, Place, Quotient, in_readme
from tests.bench.figures.readings import at, over
from tests.bench.figures.tolerances import count_of, exactly, rms_of, speed

EXTRACTION = Command("crenel bench extraction")
CLIPPED = Command("crenel bench extraction --clipped")
SMOOTHING = Command("python -m tests.bench.smoothing")
SECTION, README_ROW = "Stripe extraction", "Stripe extraction"
CRENEL, OPENCV, NUMPY = "Crenel", "OpenCV Gauss + parabola", "numpy argmax + centroid"
POINTS = 15_000
"""Of twelve frames of 1280 columns with gaps."""
KINDS = {"plain": POINTS, "speckle": POINTS // 4, "speckle, round grains": POINTS // 8}
"""Points with noise of their own: neighbours of a speckled line err alike."""


def measure(name: str, method: str = "crenel") -> Read:
    return at("measures", {"measure": name}, method)


def rates() -> Iterator[Figure]:
    """Over those of the peers: an absolute rate says what the machine is."""
    whole, followed = "whole frames per second", "frames per second with stripe tracking"
    own = Place(ACCURACY, SECTION, (whole,), CRENEL)
    also = in_readme(README_ROW, r"([\d ]+) frames of")
    extraction = "whole-frame extraction"
    for column, key in ((OPENCV, "opencv"), (NUMPY, "centroid")):
        peer = Place(ACCURACY, SECTION, (whole,), column)
        places = (Quotient(own, peer), Quotient(also, peer))
        read = over(measure(extraction), measure(extraction, key))
        name = f"extraction, rate over {column}"
        yield Figure(name, EXTRACTION, places, read, Better.LARGER, speed())
    ratio = (Quotient(Place(ACCURACY, SECTION, (followed,), CRENEL), own),)
    read = over(measure("with the stripe followed"), measure(extraction))
    name = "extraction, rate with tracking over that of whole frames"
    yield Figure(name, EXTRACTION, ratio, read, Better.LARGER, speed())
    for which, width in enumerate((20, 50)):
        place = Place(ACCURACY, SECTION, ("the same with a line 20 px",), CRENEL, which)
        wide = measure(f"the same, {width} px wide at half height")
        read = over(wide, measure("with the stripe followed"))
        what = f"extraction, rate with a line {width} px wide over a narrow one"
        yield Figure(what, EXTRACTION, (place,), read, Better.LARGER, speed())


def errors() -> Iterator[Figure]:
    speckled = "the same with speckle; with round grains"
    rows = ("rms error / Cramér-Rao bound", speckled, speckled)
    for number, (kind, points) in enumerate(KINDS.items()):
        for column, key, better in (
            (CRENEL, "crenel", Better.SMALLER),
            (OPENCV, "opencv", Better.AS_PRINTED),
            (NUMPY, "centroid", Better.AS_PRINTED),
        ):
            which = 1 if number == 2 else 0
            place = Place(ACCURACY, SECTION, (rows[number],), column, which)
            places = [place]
            if number == 0 and key == "crenel":
                places.append(in_readme(README_ROW, r"error ([\d.]+) times"))
            name = f"extraction, error / bound, {kind}: {column}"
            read, tolerance = measure(f"rms error / bound, {kind}", key), rms_of(points, "points")
            yield Figure(name, EXTRACTION, tuple(places), read, better, tolerance)
        place = Place(ACCURACY, SECTION, ("rms of error / stated",), CRENEL, number)
        name = f"extraction, error / stated deviation, {kind}"
        read = measure(f"rms of error / stated deviation, {kind}")
        tolerance = rms_of(points, "points")
        yield Figure(name, EXTRACTION, (place,), read, Better.NEAR_ONE, tolerance)


def nuisances() -> Iterator[Figure]:
    false = "false points a frame, a reflection, a lamp's spot, 60 hot pixels"
    places = (Place(ACCURACY, SECTION, ("false points per frame",), CRENEL),)
    name = "extraction, false points per frame"
    none = exactly("none is allowed")
    yield Figure(name, EXTRACTION, places, measure(false), Better.SMALLER, none)
    places = (Place(ACCURACY, SECTION, ("missed columns",), CRENEL),)
    read, tolerance = measure("missed columns, the same"), count_of(POINTS, "columns", 100 / POINTS)
    name = "extraction, missed columns, %"
    yield Figure(name, EXTRACTION, places, read, Better.SMALLER, tolerance)
    places = (Place(ACCURACY, SECTION, ("saturated patch",), CRENEL),)
    read, tolerance = measure("saturated patch, rms"), rms_of(200, "independent points")
    yield Figure("extraction, saturated", EXTRACTION, places, read, Better.SMALLER, tolerance)


def clipped() -> Iterator[Figure]:
    for label, kind in (
        ("a spot of 12 × 12 pixels", "a spot of 12 × 12 pixels"),
        ("80 columns of the line", "80 columns of the line"),
        ("half of the line", "half of the line"),
        ("all of the line", "all of the line"),
    ):
        for column, bits, key in (
            ("8 bit", 8, "full_search_share"),
            ("16 bit", 16, "full_search_share"),
            ("8 bit, tracked", 8, "followed_share"),
            ("16 bit, tracked", 16, "followed_share"),
        ):
            place = Place(ACCURACY, SECTION, (label,), column, pattern=r"\((\d+) %\)")
            read = _percent_of(kind, bits, key)
            name = f"clipped, {kind}, {column}: rate over plain, %"
            yield Figure(name, CLIPPED, (place,), read, Better.LARGER, speed())
        if label.startswith("a spot"):
            continue
        place = Place(ACCURACY, SECTION, (label,), "rms error, clipped columns")
        read = at("kinds", {"kind": kind, "bits": 8}, "error_px")
        name, tolerance = f"clipped, {kind}: error", rms_of(200, "independent points")
        yield Figure(name, CLIPPED, (place,), read, Better.SMALLER, tolerance)


def _percent_of(kind: str, bits: int, key: str) -> Read:
    share = at("kinds", {"kind": kind, "bits": bits}, key)
    return lambda found: 100 * share(found)


def smoothing() -> Iterator[Figure]:
    section = "Smoothing along the line"
    kinds = {kind: points * 16 // 12 for kind, points in KINDS.items()}
    columns = {"none": 0, "1 px": 1, "2 px": 2, "5 px": 5, "10 px": 10}
    for kind, points in (kinds | {"a saturated patch": 16 * 100}).items():
        name = kind.removeprefix("a ")
        for column, smoothing_px in columns.items():
            # a line smoothed by s pixels has a point of its own every 3.5 s columns
            own = round(points / max(1.0, 3.5 * smoothing_px))
            for row, key, better in (
                ("noise", "noise, px", Better.SMALLER),
                ("claimed / observed", "claimed / observed", Better.NEAR_ONE),
            ):
                place = Place(ACCURACY, section, (f"{kind}: {row}",), column)
                what = f"smoothed by {smoothing_px} px, {name}: {row}"
                read = at(f"{name}: {key}", f"{smoothing_px} px")
                tolerance = rms_of(own, "independent points")
                yield Figure(what, SMOOTHING, (place,), read, better, tolerance)


FIGURES = (*rates(), *errors(), *nuisances(), *clipped(), *smoothing())
