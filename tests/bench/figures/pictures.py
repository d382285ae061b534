"""Figures of real pictures: boards and lines of others, and a robot's recordings."""

from collections.abc import Iterator, Mapping

from tests.bench.figures.figure import Better, Command, Figure, Read
from tests.bench.figures.printed import ACCURACY, Place, in_readme
from tests.bench.figures.readings import at, over, percent, reduced, smallest_of_rows
from tests.bench.figures.tolerances import exactly, rms_of, share_of, within

LAID_OUT = "laid out"
"""Stands for a folder to which ``tests.bench.real_folder`` has linked the pictures."""
BOARDS = Command("crenel bench boards FOLDER", (("FOLDER", f"{LAID_OUT}/boards"),))
REAL = Command("crenel bench real FOLDER", (("FOLDER", LAID_OUT),))
HARDER = Command("crenel bench real FOLDER --harder", (("FOLDER", LAID_OUT),))
SMOOTHED = Command("crenel bench real FOLDER --smoothing PX", (("FOLDER", LAID_OUT), ("PX", "2")))
CHARUCO = Command("python -m tests.bench.charuco")
DEFOCUSED = Command("python -m tests.bench.defocused FOLDER", (("FOLDER", "real/boards"),))
ROBOT = Command("python -m tests.bench.peers REAL", (("REAL", "real"),))
SIMULATED = Command("python -m tests.bench.boards 24 --arms 24")
SAME = exactly("the same pictures, counted")
SAME_RMS = share_of(0.02, "2 %: the same pictures; what another OpenCV leaves of them")
NOISE = share_of(0.05, "5 %: the same lines of some thousand points each")
BOARD_SETS = {"a board held": "opencv-stereo", "a board on": "carnd", "a wide-angle": "wide"}
LINE_SETS = {"a robot's sensor": "calib1", "the same, another": "calib3", "lines on welds": "weld"}
HARDER_KINDS = {
    "half size": "half size",
    "double size": "double size",
    "blurred by 1.5 px": "blurred by 1.5 px",
    "3 times as bright": "3 times as bright",
    "tinted": "tinted",
    "JPEG, quality 60": "JPEG 60",
    "JPEG, quality 30": "JPEG 30",
    "cut": "cut",
}


def boards() -> Iterator[Figure]:
    section = "Chessboards in real pictures"
    for label, name in BOARD_SETS.items():
        chosen = {"name": name}
        for column, path, better, tolerance in (
            ("Crenel", ("found", "crenel"), Better.LARGER, SAME),
            ("wrong", ("wrong",), Better.SMALLER, SAME),
            ("rms: Crenel", ("rms_px", "crenel"), Better.SMALLER, SAME_RMS),
        ):
            place = Place(ACCURACY, section, (label,), column)
            what, read = f"boards, {name}: {column}", at("sets", chosen, *path)
            yield Figure(what, BOARDS, (place,), read, better, tolerance)
    columns = {"in the hand (28)": "opencv-stereo", "on a wall (20)": "carnd"}
    columns["wide-angle (13)"] = "wide"
    for label, kind in HARDER_KINDS.items():
        for column, name in columns.items():
            place = Place(ACCURACY, section, (label,), column)
            read = at("boards", {"name": f"boards/{name}, {kind}"}, "found", "crenel")
            yield Figure(f"boards, {name}, {kind}", HARDER, (place,), read, Better.LARGER, SAME)


def charuco() -> Iterator[Figure]:
    for label, name in (
        ("blur 1 px", "blur 1 px, noise 1"),
        ("noise 8", "noise 8"),
        ("blur 2 px", "blur 2 px"),
        ("JPEG, quality 20", "JPEG, quality 20"),
    ):
        for column, key, better, tolerance in (
            (1, "Crenel, found", Better.LARGER, exactly("all corners of the boards")),
            (2, "Crenel, px", Better.SMALLER, rms_of(2 * 336, "coordinates")),
            (4, "OpenCV, px", Better.AS_PRINTED, rms_of(2 * 336, "coordinates")),
        ):
            place = Place(ACCURACY, "Chessboards in real pictures", (label,), column)
            what = f"ChArUco, {name}: {key}"
            yield Figure(what, CHARUCO, (place,), at(name, key), better, tolerance)


def of_lines(name: str, *path: str, end: str = "") -> Read:
    return at("lines", {"name": f"lines/{name}{end}"}, *path)


def missed(name: str, end: str = "") -> Read:
    return percent(over(of_lines(name, "missed", end=end), of_lines(name, "agreed", end=end)))


def lines() -> Iterator[Figure]:
    for label, name in LINE_SETS.items():
        reads: Mapping[str, tuple[Read, Better]] = {
            "with line": (of_lines(name, "with_line"), Better.LARGER),
            "points": (of_lines(name, "points"), Better.LARGER),
            "missed": (missed(name), Better.SMALLER),
            "false": (of_lines(name, "false", "crenel"), Better.SMALLER),
            "noise: Crenel": (of_lines(name, "noise_px", "crenel"), Better.SMALLER),
        }
        for column, (read, better) in reads.items():
            place = Place(ACCURACY, "Real pictures", (label,), column)
            noise = column.startswith("noise")
            again = Place(ACCURACY, "Smoothing along the line", (label,), "none")
            places, tolerance = ((place, again), NOISE) if noise else ((place,), SAME)
            yield Figure(f"lines, {name}: {column}", REAL, places, read, better, tolerance)
    for label, name in BOARD_SETS.items():
        place = Place(ACCURACY, "Real pictures", (label,), "columns with points")
        read = at("no_line", {"name": f"boards/{name}"}, "points")
        yield Figure(f"no line, {name}: points", REAL, (place,), read, Better.SMALLER, SAME)
    of_sets = [missed(name) for name in LINE_SETS.values()]
    pictures = [
        at("no_line", {"name": f"boards/{name}"}, "pictures") for name in BOARD_SETS.values()
    ]
    for what, pattern, read, better in (
        ("lowest share missed", r"([\d.]+) to [\d.]+ %", reduced(min, of_sets), Better.SMALLER),
        ("highest share missed", r"to ([\d.]+) %", reduced(max, of_sets), Better.SMALLER),
        (
            "pictures without a line",
            r"in (\d+) pictures",
            reduced(sum, pictures),
            Better.AS_PRINTED,
        ),
    ):
        places = (in_readme("Lines in pictures", pattern),)
        yield Figure(f"README, lines: {what}", REAL, places, read, better, SAME)


def harder_lines() -> Iterator[Figure]:
    columns = {"saturated": "calib1", "another recording": "calib3", "welds": "weld"}
    for label, kind in HARDER_KINDS.items():
        for column, name in columns.items():
            end = f", {kind}"
            for which, what, read in (
                (0, "missed", missed(name, end)),
                (1, "false", of_lines(name, "false", "crenel", end=end)),
            ):
                place = Place(ACCURACY, "Real pictures", (label,), column, which)
                figure = f"lines, {name}, {kind}: {what}"
                yield Figure(figure, HARDER, (place,), read, Better.SMALLER, SAME)


def smoothed_lines() -> Iterator[Figure]:
    for label, name in LINE_SETS.items():
        place = Place(ACCURACY, "Smoothing along the line", (label,), "2 px")
        read = of_lines(name, "noise_px", "crenel")
        what = f"lines, {name}, smoothed by 2 px: noise"
        yield Figure(what, SMOOTHED, (place,), read, Better.SMALLER, NOISE)


def defocused() -> Iterator[Figure]:
    few = within(3.0, "3 of 366 pictures: their noise is another with another numpy")
    for light in ("0.15", "0.4", "1"):
        for height in ("80", "160", "260"):
            name = f"room {light}, line {height}"
            for column, key in (("found", "found"), ("found with the widths set", "found_as_set")):
                place = Place(ACCURACY, "Defocused lines", (light, height), column)
                what, read = f"defocused, {name}: {column}", at(name, key)
                yield Figure(what, DEFOCUSED, (place,), read, Better.LARGER, few)


def robot() -> Iterator[Figure]:
    for recording, first in (("calib1", 1), ("calib3", 4)):
        theirs = f"{recording}: OpenCV's corners"
        hand_eye, together = (f"{theirs}, k1", f"{theirs}, 5 terms"), f"{theirs}, least squares"
        for label, which, key in (
            ("corners to the board", 0, "corners px"),
            ("board's origin", 0, "origin mm"),
            ("all its corners", 0, "pattern mm"),
            ("laser points to one plane", 0, "laser mm"),
            ("laser points of all pictures", 0, "plane mm"),
            ("the last two without", 0, "laser*"),
            ("the last two without", 1, "plane*"),
        ):
            if "*" in key and recording == "calib3":
                continue  # no picture of it is left out
            for who, column, read, better in (
                ("Crenel", 0, at(f"{recording}: Crenel", key), Better.SMALLER),
                ("OpenCV", 1, smallest_of_rows(key, *hand_eye), Better.AS_PRINTED),
                ("least squares", 2, smallest_of_rows(key, together), Better.AS_PRINTED),
            ):
                place = Place(ACCURACY, "Chessboard", (label,), first + column, which)
                what = f"robot, {recording}, {key}: {who}"
                yield Figure(what, ROBOT, (place,), read, better, NOISE)
        sentence = r"mounting give ([^(]*)\(" if first == 1 else r"second recording ([^(]*) mm\."
        for which, key in enumerate(("origin mm", "laser mm", "plane mm")):
            place = Place(ACCURACY, "Chessboard", which=which, pattern=sentence)
            read = at(f"{recording}: Crenel's camera and mounting, flat board", key)
            what = f"robot, {recording}, {key}: flat board"
            yield Figure(what, ROBOT, (place,), read, Better.SMALLER, NOISE)


def simulated_boards() -> Iterator[Figure]:
    # the error of a session is the rms over a volume that some six parameters move
    sessions = rms_of(24, "sessions")
    for label, name in (
        ("bent board", "robot off by 0.3 mrad, 0.05 mm"),
        ("with a board that rocks", "the same, the board rocks by 1.5 mrad"),
        ("with a better robot", "robot off by 0.05 mrad, 0.02 mm"),
        ("with laser lines off their plane by 5", "the same, lines off by 5 µm, not 50"),
        ("with laser lines off their plane by 200", "the same, lines off by 200 µm"),
    ):
        place = Place(ACCURACY, "Chessboard", (label,), "claimed / observed")
        read = at(name, "claimed / observed")
        yield Figure(f"board, {label}", SIMULATED, (place,), read, Better.NEAR_ONE, sessions)
    for off, key, pattern in (
        (20, "observed, µm", r"are both (\d+) µm"),
        (20, "claimed, µm", r"are both (\d+) µm"),
        (45, "observed, µm", r"(\d+) µm are observed"),
        (45, "claimed, µm", r"observed and (\d+) µm claimed"),
    ):
        place = Place(ACCURACY, "Chessboard", pattern=pattern)
        read = at(f"the station's board, arms off by {off} µm", key)
        better = Better.SMALLER if key.startswith("obs") else Better.AS_PRINTED
        what = f"the station's board, arms off by {off} µm: {key}"
        yield Figure(what, SIMULATED, (place,), read, better, sessions)


FIGURES = (
    *boards(),
    *charuco(),
    *lines(),
    *harder_lines(),
    *smoothed_lines(),
    *defocused(),
    *robot(),
    *simulated_boards(),
)
