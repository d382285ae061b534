"""Figures of performance tests: noise, planted faults, and the stated uncertainty of each."""

from collections.abc import Iterator

from tests.bench.figures.figure import Command, Figure, Tolerance
from tests.bench.figures.printed import in_readme
from tests.bench.figures.readings import at, reduced
from tests.bench.figures.section import AS_PRINTED, NEAR_ONE, Section
from tests.bench.figures.tolerances import mean_of, rms_of, within

DRAWN = Section(Command("python -m tests.bench performance"), "Performance tests")
RENDERED = Section(Command("python -m tests.bench performance --rendered"), "Performance tests")
MATRIX = "probe matrix off by 50"
STATED = ", stated / observed"
TIP_UM, MOVED_UM = 1.7, 2.4
"""Standard deviations of the size and of the movement of a sphere touched with 3 µm."""
IMPLIED_OFFSETS = "implied offset along x, y, z"
OUTLIERS = ("P_Form.Sph.D95% by scan", "P_Form.Sph.1x25 by scan", "P_Size.Sph.All by scan")
IMPLIED = [f"probe matrix off along {axis}, implied" for axis in "xyz"]
# five centres that scatter by 3 µm
OF_IMPLIED = within(3 * 1.3, "3·1.3 µm: the centre of a sphere of five scans")
OF_TOUCHES = "3 standard deviations of a sphere that is touched with 3 µm"
OF_PATCHES = within(3.0, "3·1.0 µm: the range of 25 patches")
# the sphere about five centres, each of which scatters by some µm
OF_CENTRES = within(24.0, "3·8 µm: the sphere about the centres of five scans")
OF_SCANS = within(3.0, "3·1 µm: the size or form of a sphere by five scans")
OF_SAME_TOUCHES = within(3 * 0.1, "the same touches with the same noise")


def drawn() -> Iterator[Figure]:
    range_of, rms = mean_of(10_000, 0.18, "draws"), rms_of(10_000, "draws")
    for label, name, which, tolerance in (
        ("range of 25", "range of 25 points about a known centre", 0, range_of),
        ("form of 25", "form of 25 points about the fitted centre", 0, range_of),
        ("dispersion D95", "dispersion D95 of 20 000 points", 0, mean_of(200, 0.01, "draws")),
        ("sphere about", "sphere about five centres, mean", 0, mean_of(10_000, 0.25, "draws")),
        ("centre, across", "centre, across the pole", 0, rms),
        ("centre, across", "centre, along the pole", 1, rms),
        *((f"{MATRIX} along x, y, z", IMPLIED[axis], axis, OF_IMPLIED) for axis in range(3)),
        (
            "tip worn by 20: ",
            "tip worn by 20 µm, P_Size by touch",
            0,
            within(3 * TIP_UM, OF_TOUCHES),
        ),
        ("sphere moved", "sphere moved by 100 µm", 0, within(3 * MOVED_UM, OF_TOUCHES)),
        ("4 % outliers: ", "4 % outliers, growth of P_Form by scan", 0, OF_PATCHES),
    ):
        row = (label, "100") if label == "sphere moved" else (label,)
        read = at("figures", {"figure": name}, "found")
        yield DRAWN(f"drawn, {name}", (row, "found", which), read, AS_PRINTED, tolerance)
    implied = [at("figures", {"figure": name}, "found") for name in IMPLIED]
    for what, pattern, of in (
        ("smallest", r"found as ([\d.]+) to", min),
        ("largest", r"to ([\d.]+) µm, with", max),
    ):
        place, read = in_readme("Performance tests", pattern), reduced(of, implied)
        yield DRAWN(f"README, implied error: {what}", place, read, AS_PRINTED, OF_IMPLIED)


def stated() -> Iterator[Figure]:
    tests, draws = rms_of(200, "tests"), rms_of(1000, "draws")
    rows = {
        "`P_Size` by touch": ("size-touch",),
        "`P_Form` by touch": ("form-touch",),
        "`L_Dia` by touch": ("location-touch",),
        "`P_Size.Sph.1x25` by scan": ("size-scan",),
        "`P_Size.Sph.All` by scan": ("size-all-scan",),
        "`P_Form.Sph.1x25` by scan": ("form-scan",),
        "`P_Form.Sph.D95%` by scan": ("dispersion-scan",),
        "`L_Dia` by scan": ("location-scan",),
        "touch against scan": ("size-both", "form-both", "location-both"),
        "`E_Uni`": ("length-touch",),
        "`E_Form.Pla.D95%`": ("plane-scan",),
        "length by scan": ("length-scan",),
        "effective diameter": ("effective-diameter",),
        "volumetric length": ("volumetric-largest", "volumetric-two-rms"),
        IMPLIED_OFFSETS: tuple(f"implied offset along {axis}" for axis in "xyz"),
    }
    for label, names in rows.items():
        implied = label == IMPLIED_OFFSETS
        column, tolerance = ("found", draws) if implied else ("stated / observed", tests)
        for which, name in enumerate(names):
            read = at("figures", {"figure": name + STATED}, "found")
            yield DRAWN(name + STATED, (label, column, which), read, NEAR_ONE, tolerance)


def rendered() -> Iterator[Figure]:
    scanned, touched = (
        ("L_Dia by scan", "P_Size.Sph.1x25 by scan"),
        ("P_Size by touch", "L_Dia by touch"),
    )
    for label, fault, names in (
        *((f"{MATRIX} along {axis}", f"{MATRIX} µm along {axis}", scanned) for axis in "xyz"),
        ("scale of the", "sensor's scale 0.1 % too large", scanned),
        (
            "second link",
            "second link 0.1 mm longer than stated",
            ("E_Uni by touch, largest", *touched),
        ),
        ("tip worn", "tip worn by 20 µm", (*touched, "P_Form by touch")),
        ("sphere moved", "sphere moved by 100 µm", ("movement",)),
        ("4 % outliers", "4 % outliers", OUTLIERS),
    ):
        for name in names:
            quantity, by, how = name.partition(" by ")
            row = (label, f"`{quantity}` by {how.removesuffix(', largest')}" if by else quantity)
            of_scan = OF_CENTRES if quantity == "L_Dia" else OF_SCANS
            tolerance = of_scan if how == "scan" else OF_SAME_TOUCHES
            yield found_under(fault, name, row, tolerance)
    # the name of these rows holds the expanded uncertainty, which is their tolerance
    for axis, U_um in (("x", 4.1), ("y", 5.9), ("z", 13.5)):
        tolerance = within(1.5 * U_um, f"3 standard uncertainties of {U_um / 2:.2f} µm")
        fault, row = f"{MATRIX} µm along {axis}", (f"{MATRIX} along {axis}", "implied error")
        yield found_under(fault, f"implied error, U = {U_um}", row, tolerance)


def found_under(fault: str, name: str, row: tuple[str, str], tolerance: Tolerance) -> Figure:
    read = at("faults", {"fault": fault, "figure": name}, "found")
    what = f"rendered, {fault}: {name.partition(', U =')[0]}"
    return RENDERED(what, (row, "found"), read, AS_PRINTED, tolerance)


FIGURES = (*drawn(), *stated(), *rendered())
