"""Figures of calibrations on a block, of the faults found there, and of the gauges."""

from collections.abc import Iterator

from tests.bench.figures.figure import Command, Figure
from tests.bench.figures.printed import in_readme
from tests.bench.figures.readings import at, smallest_of_rows
from tests.bench.figures.section import AS_PRINTED, LARGER, NEAR_ONE, SMALLER, Section
from tests.bench.figures.tolerances import count_of, mean_of, rms_of, share_of
from tests.bench.outlier_contacts import TOUCHED

SAMPLES = Command("python -m tests.bench accuracy SAMPLES", (("SAMPLES", "samples"),))
PEERS = Command("python -m tests.bench many-poses --sessions 16")
WRONG_PARAMETERS = Command(PEERS.documented, more=("--wrong-in", "parameters"))
FAULTS = Command("python -m tests.bench fault-identification")
OUTLIERS = Command("python -m tests.bench outlier-contacts --first 100000")
GAUGES = Command("python -m tests.bench gauges SAMPLES", (("SAMPLES", "samples"),))
NAMES = ("one-pose", "many-poses", "metal")
SAMPLE = share_of(0.25, "1/√(2·8): the same pictures, whose noise moves eight unknowns")
WORST = share_of(0.6, "3·0.2: the largest of 20 sessions that scatter by half")
SESSIONS = mean_of(16, 0.5, "sessions")
SESSIONS_RMS = rms_of(16, "sessions")
IN_README = "flange, median µm"


def samples() -> Iterator[Figure]:
    one_pose, all_poses = Section(SAMPLES, "One pose"), Section(SAMPLES, "Many poses")
    for column, key, better in (
        ("sensor frame, rms", "sensor, µm", SMALLER),
        ("linear method alone", "linear only, µm", AS_PRINTED),
        ("flange frame, rms", "flange, µm", SMALLER),
        ("claimed", "claimed, µm", AS_PRINTED),
    ):
        for label, name, tolerance in (
            *((f"sample `{name}`", name, SAMPLE) for name in NAMES),
            ("20 random sessions, median", "random, median", mean_of(20, 0.5, "sessions")),
            ("the worst of them", "random, worst", WORST),
        ):
            what = f"one pose, {name}: {column}"
            yield one_pose(what, (label, column), at(name, key), better, tolerance)
        for name in NAMES if key != "linear only, µm" else ():
            what, read = f"all poses, {name}: {column}", at(f"{name}, joint", key)
            yield all_poses(what, (f"`{name}`", column), read, better, SAMPLE)


def beside_opencv() -> Iterator[Figure]:
    figure, row = Section(PEERS, "Many poses"), "Guided calibration"
    own = in_readme(row, r"(\d+) µm rms \(median of 16 sessions\)")
    theirs = in_readme(row, r"OpenCV reaches (\d+) µm")
    for column, key, tolerance in (
        ("sensor frame, rms", "sensor, median µm", SESSIONS),
        ("flange frame, rms", "flange, median µm", SESSIONS),
        ("rms over the sessions", "flange, rms µm", SESSIONS_RMS),
    ):
        best = smallest_of_rows(key, "OpenCV, contacts")
        for label, name, read, better, readme in (
            ("Crenel (claims 18 µm)", "Crenel", at("Crenel", key), SMALLER, own),
            ("OpenCV, contact points", "OpenCV, contacts", best, AS_PRINTED, theirs),
        ):
            what, also = f"16 sessions, {name}: {column}", readme if key == IN_README else None
            yield figure(what, (label, column), read, better, tolerance, also)
    read = at("Crenel, as claimed", IN_README)
    yield figure("16 sessions, claimed", ("Crenel (claims", 0), read, AS_PRINTED, SESSIONS)
    figure, claim = Section(WRONG_PARAMETERS, "Many poses"), "Crenel's error over its claim, rms"
    for key, pattern, row, better, tolerance in (
        ("flange, median µm", r"reaches (\d+) µm \(median", "Crenel", SMALLER, SESSIONS),
        ("flange, rms µm", r"and (\d+) µm over", "Crenel", SMALLER, SESSIONS_RMS),
        (claim, r"([\d.]+) times its claim", "sessions", NEAR_ONE, SESSIONS_RMS),
    ):
        what = f"16 sessions, wrong parameters: {key}"
        yield figure(what, pattern, at(row, key), better, tolerance)


def fault_detection() -> Iterator[Figure]:
    figure, tolerance = Section(FAULTS, "Fault detection"), count_of(40, "sessions, in %", 2.5)
    for label, name in (
        ("none", "none"),
        ("tip 0.1 mm too large", "tip 0.1 mm too large"),
        ("tip off by 0.1 mm", "tip 0.1 mm from its place"),
        ("tip off by 0.3 mm", "tip 0.3 mm from its place"),
        ("block moved by 0.1 mm", "block moved by 0.1 mm, 0.05 deg"),
        ("block moved by 0.3 mm", "block moved by 0.3 mm, 0.2 deg"),
        ("certificate 0.3 %", "certificate 0.3 % too large"),
        ("certificate 1 %", "certificate 1 % too large"),
    ):
        for arm in ("25", "100", "250"):
            for which, key, better in ((0, "right", LARGER), (1, "other", SMALLER)):
                what, read = f"{label}, arm off by {arm} µm: {key}", at(name, f"{arm} um, {key}, %")
                yield figure(what, (label, f"{arm} µm", which), read, better, tolerance)


def outliers() -> Iterator[Figure]:
    figure = Section(OUTLIERS, "Outliers among contact points")
    for name, touched in TOUCHED.items():
        sets = 500 // touched.slow
        tolerance = count_of(sets, "sets, in %", 100 / sets)
        for column, key, better, counts in (
            ("good point named", "good named", SMALLER, (0, 1, 2)),
            ("in doubt", "in doubt", SMALLER, (0, 1, 2)),
            ("outlier named", "named", LARGER, (1, 2)),
            ("clear outlier overlooked", "overlooked", SMALLER, (1, 2)),
        ):
            for which, count in enumerate(counts):
                what, read = f"{name}, {count} outliers: {key}", at(name, f"{count}: {key}")
                yield figure(what, (name, column, which), read, better, tolerance)


def gauges() -> Iterator[Figure]:
    figure = Section(GAUGES, "Gauges")
    for row, which, name, key, pattern in (
        ("plane: angle", 0, "plane", "angle_arcsec", r"plane: (\d+)″"),
        ("plane: angle", 1, "plane", "offset_error_um", r"″ and ([\d.]+) µm"),
        ("plane, sensor tilted", 0, "plane_tilted", "angle_arcsec", ""),
        ("plane, sensor tilted", 1, "plane_tilted", "offset_error_um", ""),
        ("sphere: radius", 0, "sphere", "radius_error_um", r"radius ([\d.]+) µm"),
        ("sphere: radius", 1, "sphere", "centre_error_um", r"centre ([\d.]+) µm"),
    ):
        also = in_readme("Verification on a plane or sphere gauge", pattern) if pattern else None
        yield figure(f"gauge, {name}: {key}", (row, 1, which), at(name, key), SMALLER, SAMPLE, also)


FIGURES = (*samples(), *beside_opencv(), *fault_detection(), *outliers(), *gauges())
