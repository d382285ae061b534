"""Figures of performance tests: noise, planted faults, and the stated uncertainty of each."""

from collections.abc import Iterator

from tests.bench.figures.figure import Better, Command, Figure, Tolerance
from tests.bench.figures.printed import ACCURACY, Place, in_readme
from tests.bench.figures.readings import at, reduced
from tests.bench.figures.tolerances import mean_of, rms_of, within

DRAWN = Command("crenel bench performance")
RENDERED = Command("crenel bench performance --rendered")
SECTION = "Performance tests"
MATRIX = "probe matrix off by 50"
STATED = ", stated / observed"
TOUCHED_UM, IMPLIED_UM, TIP_UM, MOVED_UM, GROWTH_UM = 0.1, 1.3, 1.7, 2.4, 1.0
"""Standard deviations: of what is touched with the same noise; of the direction of five centres
that scatter by 3 µm; of the size and of the movement of a sphere touched with 3 µm; of the form of
25 patches of a scan."""
IMPLIED = [f"probe matrix off along {axis}, implied" for axis in "xyz"]


def drawn() -> Iterator[Figure]:
    ten = 10_000
    for label, which, name, tolerance in (
        ("range of 25", 0, "range of 25 points about a known centre", mean_of(ten, 0.18, "draws")),
        ("form of 25", 0, "form of 25 points about the fitted centre", mean_of(ten, 0.18, "draws")),
        ("dispersion D95", 0, "dispersion D95 of 20 000 points", mean_of(200, 0.01, "draws")),
        ("sphere about", 0, "sphere about five centres, mean", mean_of(ten, 0.25, "draws")),
        ("centre, across", 0, "centre, across the pole", rms_of(ten, "draws")),
        ("centre, across", 1, "centre, along the pole", rms_of(ten, "draws")),
        *(
            (*(f"{MATRIX} along x, y, z", which, name), within(3 * IMPLIED_UM, IMPLIED_REASON))
            for which, name in enumerate(IMPLIED)
        ),
        (
            "tip worn by 20: ",
            0,
            "tip worn by 20 µm, P_Size by touch",
            within(3 * TIP_UM, TOUCHES_REASON),
        ),
        ("sphere moved", 0, "sphere moved by 100 µm", within(3 * MOVED_UM, TOUCHES_REASON)),
        (
            "4 % outliers: ",
            0,
            "4 % outliers, growth of P_Form by scan",
            within(3.0, PATCHES_REASON),
        ),
    ):
        row = (label, "100") if label == "sphere moved" else (label,)
        place = Place(ACCURACY, SECTION, row, "found", which)
        read = at("figures", {"figure": name}, "found")
        yield Figure(f"drawn, {name}", DRAWN, (place,), read, Better.AS_PRINTED, tolerance)
    for which, axis in enumerate("xyz"):
        place = Place(ACCURACY, SECTION, ("implied offset along x, y, z",), "found", which)
        name = f"implied offset along {axis}"
        read = at("figures", {"figure": name + STATED}, "found")
        draws = rms_of(1000, "draws")
        yield Figure(name + STATED, DRAWN, (place,), read, Better.NEAR_ONE, draws)


IMPLIED_REASON = f"3·{IMPLIED_UM} µm: the centre of a sphere of five scans"
TOUCHES_REASON = "3 standard deviations of a sphere that is touched with 3 µm"
PATCHES_REASON = f"3·{GROWTH_UM} µm: the range of 25 patches"


def implied_in_the_readme() -> Iterator[Figure]:
    implied = [at("figures", {"figure": name}, "found") for name in IMPLIED]
    for what, pattern, of in (
        ("smallest", r"found as ([\d.]+) to", min),
        ("largest", r"to ([\d.]+) µm, with", max),
    ):
        places = (in_readme("Performance tests", pattern),)
        name, tolerance = f"README, implied error: {what}", within(3 * IMPLIED_UM, IMPLIED_REASON)
        read = reduced(of, implied)
        yield Figure(name, DRAWN, places, read, Better.AS_PRINTED, tolerance)


def stated() -> Iterator[Figure]:
    for label, which, name in (
        ("`P_Size` by touch", 0, "size-touch"),
        ("`P_Form` by touch", 0, "form-touch"),
        ("`L_Dia` by touch", 0, "location-touch"),
        ("`P_Size.Sph.1x25` by scan", 0, "size-scan"),
        ("`P_Size.Sph.All` by scan", 0, "size-all-scan"),
        ("`P_Form.Sph.1x25` by scan", 0, "form-scan"),
        ("`P_Form.Sph.D95%` by scan", 0, "dispersion-scan"),
        ("`L_Dia` by scan", 0, "location-scan"),
        ("touch against scan", 0, "size-both"),
        ("touch against scan", 1, "form-both"),
        ("touch against scan", 2, "location-both"),
        ("`E_Uni`", 0, "length-touch"),
        ("`E_Form.Pla.D95%`", 0, "plane-scan"),
        ("length by scan", 0, "length-scan"),
        ("effective diameter", 0, "effective-diameter"),
        ("volumetric length", 0, "volumetric-largest"),
        ("volumetric length", 1, "volumetric-two-rms"),
    ):
        place = Place(ACCURACY, SECTION, (label,), "stated / observed", which)
        read = at("figures", {"figure": name + STATED}, "found")
        tests = rms_of(200, "tests")
        yield Figure(name + STATED, DRAWN, (place,), read, Better.NEAR_ONE, tests)


def rendered() -> Iterator[Figure]:
    scan = within(3.0, "3·1 µm: the size or form of a sphere by five scans")
    # the sphere about five centres, each of which scatters by some µm
    location = within(24.0, "3·8 µm: the sphere about the centres of five scans")
    touch = within(3 * TOUCHED_UM, "the same touches with the same noise")
    link, tip = "second link 0.1 mm longer than stated", "tip worn by 20 µm"
    for label, row, fault, figure, tolerance in (
        *(_matrix_row(axis, "L_Dia", location) for axis in "xyz"),
        *(_matrix_row(axis, "P_Size.Sph.1x25", scan) for axis in "xyz"),
        (*_scale("L_Dia"), location),
        (*_scale("P_Size.Sph.1x25"), scan),
        ("second link", "`E_Uni` by touch", link, "E_Uni by touch, largest", touch),
        ("second link", "`L_Dia` by touch", link, "L_Dia by touch", touch),
        ("second link", "`P_Size` by touch", link, "P_Size by touch", touch),
        ("tip worn", "`P_Size` by touch", tip, "P_Size by touch", touch),
        ("tip worn", "`P_Form` by touch", tip, "P_Form by touch", touch),
        ("tip worn", "`L_Dia` by touch", tip, "L_Dia by touch", touch),
        ("sphere moved", "movement", "sphere moved by 100 µm", "movement", touch),
        *(
            ("4 % outliers", f"`{name}` by scan", "4 % outliers", f"{name} by scan", scan)
            for name in ("P_Form.Sph.D95%", "P_Form.Sph.1x25", "P_Size.Sph.All")
        ),
    ):
        read = at("faults", {"fault": fault, "figure": figure}, "found")
        place = Place(ACCURACY, SECTION, (label, row), "found")
        what = f"rendered, {fault}: {figure}"
        yield Figure(what, RENDERED, (place,), read, Better.AS_PRINTED, tolerance)


def _matrix_row(axis: str, name: str, tolerance: Tolerance) -> tuple[str, str, str, str, Tolerance]:
    fault, label = f"{MATRIX} µm along {axis}", f"{MATRIX} along {axis}"
    return label, f"`{name}` by scan", fault, f"{name} by scan", tolerance


def _scale(name: str) -> tuple[str, str, str, str]:
    return "scale of the", f"`{name}` by scan", "sensor's scale 0.1 % too large", f"{name} by scan"


def rendered_offsets() -> Iterator[Figure]:
    """The name of these rows holds the expanded uncertainty, which is their tolerance."""
    for axis, U_um in (("x", 4.1), ("y", 5.9), ("z", 13.5)):
        label, fault = f"{MATRIX} along {axis}", f"{MATRIX} µm along {axis}"
        place = Place(ACCURACY, SECTION, (label, "implied error"), "found")
        chosen = {"fault": fault, "figure": f"implied error, U = {U_um}"}
        tolerance = within(1.5 * U_um, f"3 standard uncertainties of {U_um / 2:.2f} µm")
        read = at("faults", chosen, "found")
        what = f"rendered, {fault}: implied error"
        yield Figure(what, RENDERED, (place,), read, Better.AS_PRINTED, tolerance)


FIGURES = (*drawn(), *implied_in_the_readme(), *stated(), *rendered(), *rendered_offsets())
