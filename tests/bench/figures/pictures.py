"""Figures of real pictures: boards and lines of others, and a robot's recordings."""

from collections.abc import Iterator

from tests.bench.figures.figure import Command, Figure, Read
from tests.bench.figures.printed import in_readme
from tests.bench.figures.readings import at, over, percent, reduced, smallest_of_rows
from tests.bench.figures.section import AS_PRINTED, LARGER, NEAR_ONE, SMALLER, Section
from tests.bench.figures.tolerances import exactly, rms_of, share_of, within

LAID_OUT = "laid out"
"""Stands for a folder to which ``tests.bench.real_folder`` has linked the pictures."""
BOARDS = Command("python -m tests.bench boards FOLDER", (("FOLDER", f"{LAID_OUT}/boards"),))
REAL = Command("python -m tests.bench real FOLDER", (("FOLDER", LAID_OUT),))
HARDER = Command("python -m tests.bench real FOLDER --harder", (("FOLDER", LAID_OUT),))
SMOOTHED = Command(
    "python -m tests.bench real FOLDER --smoothing PX", (("FOLDER", LAID_OUT), ("PX", "2"))
)
CHARUCO = Command("python -m tests.bench charuco")
DEFOCUSED = Command("python -m tests.bench defocused FOLDER", (("FOLDER", "real/boards"),))
ROBOT = Command("python -m tests.bench peers REAL", (("REAL", "real"),))
SIMULATED = Command("python -m tests.bench board-claims 24 --arms 24")
CHESSBOARDS, LINES = "Chessboards in real pictures", "Real pictures"
SAME = exactly("the same pictures, counted")
SAME_RMS = share_of(0.02, "2 %: the same pictures; what another OpenCV leaves of them")
NOISE = share_of(0.05, "5 %: the same lines of some thousand points each")
BOARD_SETS = {"a board held": "opencv-stereo", "a board on": "carnd", "a wide-angle": "wide"}
LINE_SETS = {"a robot's sensor": "calib1", "the same, another": "calib3", "lines on welds": "weld"}
HARDER_BOARDS = ("in the hand (28)", "on a wall (20)", "wide-angle (13)")
HARDER_LINES = ("saturated", "another recording", "welds")
HARDER_KINDS = (
    *("half size", "double size", "blurred by 1.5 px", "3 times as bright", "tinted"),
    *("JPEG, quality 60", "JPEG, quality 30", "cut"),
)


def boards() -> Iterator[Figure]:
    figure = Section(BOARDS, CHESSBOARDS)
    for label, name in BOARD_SETS.items():
        for column, path, better, tolerance in (
            ("Crenel", ("found", "crenel"), LARGER, SAME),
            ("wrong", ("wrong",), SMALLER, SAME),
            ("rms: Crenel", ("rms_px", "crenel"), SMALLER, SAME_RMS),
        ):
            read = at("sets", {"name": name}, *path)
            yield figure(f"boards, {name}: {column}", (label, column), read, better, tolerance)


def charuco() -> Iterator[Figure]:
    figure, all_corners = Section(CHARUCO, CHESSBOARDS), exactly("all corners of the boards")
    rms = rms_of(2 * 336, "coordinates")
    for name in ("blur 1 px, noise 1", "noise 8", "blur 2 px", "JPEG, quality 20"):
        for column, key, better, tolerance in (
            (1, "Crenel, found", LARGER, all_corners),
            (2, "Crenel, px", SMALLER, rms),
            (4, "OpenCV, px", AS_PRINTED, rms),
        ):
            place = (name.removesuffix(", noise 1"), column)
            yield figure(f"ChArUco, {name}: {key}", place, at(name, key), better, tolerance)


def of_lines(name: str, *path: str) -> Read:
    return at("lines", {"name": f"lines/{name}"}, *path)


def missed(name: str) -> Read:
    return percent(over(of_lines(name, "missed"), of_lines(name, "agreed")))


def lines() -> Iterator[Figure]:
    figure, smoothing = Section(REAL, LINES), "Smoothing along the line"
    for label, name in LINE_SETS.items():
        for column, read, better in (
            ("with line", of_lines(name, "with_line"), LARGER),
            ("points", of_lines(name, "points"), LARGER),
            ("missed", missed(name), SMALLER),
            ("false", of_lines(name, "false", "crenel"), SMALLER),
        ):
            yield figure(f"lines, {name}: {column}", (label, column), read, better, SAME)
        what, read = f"lines, {name}: noise: Crenel", of_lines(name, "noise_px", "crenel")
        unsmoothed = Section(REAL, smoothing).place(label, "none")
        yield figure(what, (label, "noise: Crenel"), read, SMALLER, NOISE, unsmoothed)
        what = f"lines, {name}, smoothed by 2 px: noise"
        yield Section(SMOOTHED, smoothing)(what, (label, "2 px"), read, SMALLER, NOISE)
    for label, name in BOARD_SETS.items():
        read = at("no_line", {"name": f"boards/{name}"}, "points")
        what, cell = f"no line, {name}: points", (label, "columns with points")
        yield figure(what, cell, read, SMALLER, SAME)
    shares = [missed(name) for name in LINE_SETS.values()]
    names = [f"boards/{name}" for name in BOARD_SETS.values()]
    pictures = [at("no_line", {"name": name}, "pictures") for name in names]
    for what, pattern, read, better in (
        ("lowest share missed", r"([\d.]+) to [\d.]+ %", reduced(min, shares), SMALLER),
        ("highest share missed", r"to ([\d.]+) %", reduced(max, shares), SMALLER),
        ("pictures without a line", r"in (\d+) pictures", reduced(sum, pictures), AS_PRINTED),
    ):
        place = in_readme("Lines in pictures", pattern)
        yield figure(f"README, lines: {what}", place, read, better, SAME)


def harder() -> Iterator[Figure]:
    of_boards, figure = Section(HARDER, CHESSBOARDS), Section(HARDER, LINES)
    for label in HARDER_KINDS:
        kind = label.replace(", quality", "")
        for column, name in zip(HARDER_BOARDS, BOARD_SETS.values(), strict=True):
            what, found = f"boards, {name}, {kind}", {"name": f"boards/{name}, {kind}"}
            read = at("boards", found, "found", "crenel")
            yield of_boards(what, (label, column), read, LARGER, SAME)
        for column, name in zip(HARDER_LINES, LINE_SETS.values(), strict=True):
            changed = f"{name}, {kind}"
            reads = {"missed": missed(changed), "false": of_lines(changed, "false", "crenel")}
            for which, (what, read) in enumerate(reads.items()):
                yield figure(
                    f"lines, {changed}: {what}", (label, column, which), read, SMALLER, SAME
                )


def defocused() -> Iterator[Figure]:
    figure = Section(DEFOCUSED, "Defocused lines")
    few = within(3.0, "3 of 366 pictures: their noise is another with another numpy")
    for light in ("0.15", "0.4", "1"):
        for height in ("80", "160", "260"):
            name = f"room {light}, line {height}"
            for column, key in (("found", "found"), ("found with the widths set", "found_as_set")):
                what, place = f"defocused, {name}: {column}", ((light, height), column)
                yield figure(what, place, at(name, key), LARGER, few)


def robot() -> Iterator[Figure]:
    figure = Section(ROBOT, "Chessboard")
    for recording, first, sentence in (
        ("calib1", 1, r"mounting give ([^(]*)\("),
        ("calib3", 4, r"second recording ([^(]*) mm\."),
    ):
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
            for column, (who, read, better) in enumerate(
                (
                    ("Crenel", at(f"{recording}: Crenel", key), SMALLER),
                    ("OpenCV", smallest_of_rows(key, *hand_eye), AS_PRINTED),
                    ("least squares", smallest_of_rows(key, together), AS_PRINTED),
                ),
                first,
            ):
                what = f"robot, {recording}, {key}: {who}"
                yield figure(what, (label, column, which), read, better, NOISE)
        for which, key in enumerate(("origin mm", "laser mm", "plane mm")):
            place = figure.place((), which=which, pattern=sentence)
            read = at(f"{recording}: Crenel's camera and mounting, flat board", key)
            yield figure(f"robot, {recording}, {key}: flat board", place, read, SMALLER, NOISE)


def simulated_boards() -> Iterator[Figure]:
    # the error of a session is the rms over a volume that some six parameters move
    figure, sessions = Section(SIMULATED, "Chessboard"), rms_of(24, "sessions")
    ratio = "claimed / observed"
    for label, name in (
        ("bent board", "robot off by 0.3 mrad, 0.05 mm"),
        ("with a board that rocks", "the same, the board rocks by 1.5 mrad"),
        ("with a better robot", "robot off by 0.05 mrad, 0.02 mm"),
        ("with laser lines off their plane by 5", "the same, lines off by 5 µm, not 50"),
        ("with laser lines off their plane by 200", "the same, lines off by 200 µm"),
    ):
        yield figure(f"board, {label}", (label, ratio), at(name, ratio), NEAR_ONE, sessions)
    for off, key, pattern, better in (
        (20, "observed, µm", r"are both (\d+) µm", SMALLER),
        (20, "claimed, µm", r"are both (\d+) µm", AS_PRINTED),
        (45, "observed, µm", r"(\d+) µm are observed", SMALLER),
        (45, "claimed, µm", r"observed and (\d+) µm claimed", AS_PRINTED),
    ):
        name = f"the station's board, arms off by {off} µm"
        yield figure(f"{name}: {key}", pattern, at(name, key), better, sessions)


FIGURES = (
    *(*boards(), *charuco(), *lines(), *harder()),
    *(*defocused(), *robot(), *simulated_boards()),
)
