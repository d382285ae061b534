"""Figures of calibrations on a block, of the faults found there, and of the gauges."""

from collections.abc import Iterator

from tests.bench.figures.figure import Better, Command, Figure
from tests.bench.figures.printed import ACCURACY, Place, in_readme
from tests.bench.figures.readings import at, smallest_of_rows
from tests.bench.figures.tolerances import count_of, mean_of, rms_of, share_of

SAMPLES = Command("python -m tests.bench.accuracy SAMPLES", (("SAMPLES", "samples"),))
PEERS = Command("python -m tests.bench.many_poses --sessions 16")
WRONG_PARAMETERS = Command(PEERS.documented, more=("--wrong-in", "parameters"))
FAULTS = Command("python -m tests.bench.fault_identification")
GAUGES = Command("python -m tests.bench.gauges SAMPLES", (("SAMPLES", "samples"),))
SAMPLE = share_of(0.25, "1/√(2·8): the same pictures, whose noise moves eight unknowns")
SESSIONS = mean_of(16, 0.5, "sessions")
SESSIONS_RMS = rms_of(16, "sessions")


def one_pose() -> Iterator[Figure]:
    worst = share_of(0.6, "3·0.2: the largest of 20 sessions that scatter by half")
    for label, name, tolerance in (
        ("sample `one-pose`", "one-pose", SAMPLE),
        ("sample `many-poses`", "many-poses", SAMPLE),
        ("sample `metal`", "metal", SAMPLE),
        ("20 random sessions, median", "random, median", mean_of(20, 0.5, "sessions")),
        ("the worst of them", "random, worst", worst),
    ):
        for column, key, better in (
            ("sensor frame, rms", "sensor, µm", Better.SMALLER),
            ("linear method alone", "linear only, µm", Better.AS_PRINTED),
            ("flange frame, rms", "flange, µm", Better.SMALLER),
            ("claimed", "claimed, µm", Better.AS_PRINTED),
        ):
            place = Place(ACCURACY, "One pose", (label,), column)
            what = f"one pose, {name}: {column}"
            yield Figure(what, SAMPLES, (place,), at(name, key), better, tolerance)


def samples_by_all_poses() -> Iterator[Figure]:
    for name in ("one-pose", "many-poses", "metal"):
        for column, key, better in (
            ("sensor frame, rms", "sensor, µm", Better.SMALLER),
            ("flange frame, rms", "flange, µm", Better.SMALLER),
            ("claimed", "claimed, µm", Better.AS_PRINTED),
        ):
            place = Place(ACCURACY, "Many poses", (f"`{name}`",), column)
            what, read = f"all poses, {name}: {column}", at(f"{name}, joint", key)
            yield Figure(what, SAMPLES, (place,), read, better, SAMPLE)


def beside_opencv() -> Iterator[Figure]:
    own = in_readme("Guided calibration", r"(\d+) µm rms \(median of 16 sessions\)")
    theirs = in_readme("Guided calibration", r"OpenCV reaches (\d+) µm")
    for label, rows, better, readme in (
        ("Crenel (claims 18 µm)", "Crenel", Better.SMALLER, own),
        ("OpenCV, contact points", "OpenCV, contacts", Better.AS_PRINTED, theirs),
    ):
        for column, key, tolerance in (
            ("sensor frame, rms", "sensor, median µm", SESSIONS),
            ("flange frame, rms", "flange, median µm", SESSIONS),
            ("rms over the sessions", "flange, rms µm", SESSIONS_RMS),
        ):
            place = Place(ACCURACY, "Many poses", (label,), column)
            places = (place, readme) if key == "flange, median µm" else (place,)
            read = at(rows, key) if rows == "Crenel" else smallest_of_rows(key, rows)
            yield Figure(f"16 sessions, {rows}: {column}", PEERS, places, read, better, tolerance)
    claim = Place(ACCURACY, "Many poses", ("Crenel (claims",), 0)
    read = at("Crenel, as claimed", "flange, median µm")
    yield Figure("16 sessions, claimed", PEERS, (claim,), read, Better.AS_PRINTED, SESSIONS)


def wrong_parameters() -> Iterator[Figure]:
    claim = "Crenel's error over its claim, rms"
    for key, pattern, row, better, tolerance in (
        ("flange, median µm", r"reaches (\d+) µm \(median", "Crenel", Better.SMALLER, SESSIONS),
        ("flange, rms µm", r"and (\d+) µm over", "Crenel", Better.SMALLER, SESSIONS_RMS),
        (claim, r"([\d.]+) times its claim", "sessions", Better.NEAR_ONE, SESSIONS_RMS),
    ):
        place = Place(ACCURACY, "Many poses", pattern=pattern)
        what, read = f"16 sessions, wrong parameters: {key}", at(row, key)
        yield Figure(what, WRONG_PARAMETERS, (place,), read, better, tolerance)


def fault_detection() -> Iterator[Figure]:
    tolerance = count_of(40, "sessions, in %", 2.5)
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
            for which, key, better in ((0, "right", Better.LARGER), (1, "other", Better.SMALLER)):
                place = Place(ACCURACY, "Fault detection", (label,), f"{arm} µm", which)
                what, read = f"{label}, arm off by {arm} µm: {key}", at(name, f"{arm} um, {key}, %")
                yield Figure(what, FAULTS, (place,), read, better, tolerance)


def gauges() -> Iterator[Figure]:
    label = "Verification on a plane or sphere gauge"
    for row, which, name, key, pattern in (
        ("plane: angle", 0, "plane", "angle_arcsec", r"plane: (\d+)″"),
        ("plane: angle", 1, "plane", "offset_error_um", r"″ and ([\d.]+) µm"),
        ("plane, sensor tilted", 0, "plane_tilted", "angle_arcsec", ""),
        ("plane, sensor tilted", 1, "plane_tilted", "offset_error_um", ""),
        ("sphere: radius", 0, "sphere", "radius_error_um", r"radius ([\d.]+) µm"),
        ("sphere: radius", 1, "sphere", "centre_error_um", r"centre ([\d.]+) µm"),
    ):
        place = Place(ACCURACY, "Gauges", (row,), 1, which)
        places = (place, in_readme(label, pattern)) if pattern else (place,)
        yield Figure(f"gauge, {name}: {key}", GAUGES, places, at(name, key), Better.SMALLER, SAMPLE)


FIGURES = (
    *one_pose(),
    *samples_by_all_poses(),
    *beside_opencv(),
    *wrong_parameters(),
    *fault_detection(),
    *gauges(),
)
