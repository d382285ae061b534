"""``crenel detect`` and ``--draw``: corners or refusals of pictures, drawn and as a table."""

import csv
import json
from pathlib import Path

import cv2
import numpy as np
import pytest

from crenel.metrology.stripe.line_evidence import LINE_REASONS, PIECE_REASONS
from crenel.workflows.pictures.extract_stripes import extract_stripes
from tests.cli.test_cli import crenel, done, printed, refused
from tests.colours import HEIGHT, WIDTH, expose, line_rows, mosaic, render_colours
from tests.present import present


@pytest.fixture
def board(tmp_path: Path) -> Path:
    board = {"format": "crenel/object", "version": 1, "kind": "chessboard", "name": "B"}
    board |= {"serial_number": "1", "inner_corners": [5, 4], "square_mm": 20.0}
    path = tmp_path / "object.json"
    path.write_text(json.dumps(board))
    return path


def picture(path: Path) -> Path:
    squares = np.indices((5, 6)).sum(axis=0) % 2
    grey = np.kron(squares, np.ones((40, 40))) * 180 + 40
    grey = cv2.GaussianBlur(np.pad(grey, 60, constant_values=220), (0, 0), 1.0)
    noise = np.random.default_rng(0).normal(0, 1.5, grey.shape)
    cv2.imwrite(str(path), np.clip(grey + noise, 0, 255).astype(np.uint8))
    return path


def write_line(path: Path, height: float = 150.0, noise: float = 1.0, width_px: int = 120) -> Path:
    rows = np.arange(80.0)[:, None]
    grey = 20 + height * np.exp(-((rows - 40.3) ** 2) / 4.5) + np.zeros((80, width_px))
    grey += np.random.default_rng(0).normal(0, noise, grey.shape)
    cv2.imwrite(str(path), grey.round().astype(np.uint8))
    return path


def write_blank(path: Path, *shape: int) -> Path:
    cv2.imwrite(str(path), np.full(shape, 90, np.uint8))
    return path


def rows_of(table: Path) -> list[dict[str, str]]:
    with table.open() as file:
        return list(csv.DictReader(file))


def test_corners_are_listed_and_drawn(tmp_path: Path, board: Path) -> None:
    seen = picture(tmp_path / "seen.png")
    empty = write_blank(tmp_path / "empty.png", 200, 200)
    table, drawn = tmp_path / "corners.csv", tmp_path / "drawn"
    result = crenel("detect", seen, empty, "--object", board, "-o", table, "--draw", drawn)
    assert result.exit_code == 3
    assert f"{empty}: no chessboard" in result.stdout
    rows = rows_of(table)
    corners = [row for row in rows if row["image"] == str(seen)]
    assert [int(row["number"]) for row in corners] == list(range(20))
    u = sorted(float(row["u"]) for row in corners)
    np.testing.assert_allclose(u, np.repeat(99.5 + 40 * np.arange(5), 4), atol=0.2)
    assert all(0 < float(row["sigma_px"]) < 0.2 for row in corners)
    (without,) = (row for row in rows if row["image"] == str(empty))
    assert without["refusal"] == "board-not-found"
    image = present(cv2.imread(str(drawn / "seen.png")))
    assert (image[..., 0] != image[..., 1]).any()
    assert (drawn / "empty.png").is_file()
    (found,) = printed("detect", seen, "--object", board)["images"]
    assert len(found["corners"]) == 20
    assert found["refusal"] is None


def test_drawings_of_one_name_are_refused(tmp_path: Path, board: Path) -> None:
    (tmp_path / "other").mkdir()
    seen = picture(tmp_path / "a.png"), picture(tmp_path / "other" / "a.png")
    arguments = ("--object", board, "--draw", tmp_path / "drawn")
    assert "two pictures are named a" in refused("detect", *seen, *arguments)


def test_stripes_are_smoothed_as_wished(tmp_path: Path) -> None:
    line = write_line(tmp_path / "line.png", 100, noise=3.0, width_px=300)
    table = tmp_path / "s.csv"
    scatter, stated = [], []
    for smoothing in ("0", "4"):
        result = crenel("extract", line, "-o", table, "--smoothing", smoothing)
        assert result.exit_code == 0, result.output
        _, v, _, sigma_px = np.loadtxt(table, delimiter=",", skiprows=1).T
        scatter.append(np.std(v))
        stated.append(np.median(sigma_px))
    assert scatter[1] < 0.5 * scatter[0]
    assert stated[1] < 0.5 * stated[0]
    for smoothing in ("-1", "nan", "inf"):
        said = refused("extract", line, "-o", table, "--smoothing", smoothing)
        assert "the smoothing of the stripe is" in said
        assert "at most 50 px" in said


def test_stripes_are_drawn(tmp_path: Path) -> None:
    line, drawn = write_line(tmp_path / "line.png"), tmp_path / "drawn"
    done("extract", line, "-o", tmp_path / "s.csv", "--draw", drawn)
    image = present(cv2.imread(str(drawn / "line.png")))
    red = (image[:80, :, 2] > image[:80, :, 0]).any(axis=1)
    assert np.flatnonzero(red).tolist() == [39, 40, 41]
    assert image[80:].any()  # what took it, in words


def test_pictures_without_a_line_are_listed_and_the_others_written(tmp_path: Path) -> None:
    lines = [write_line(tmp_path / name) for name in ("first.png", "last.png")]
    empty, broken, table = (tmp_path / name for name in ("empty.png", "broken.png", "s.csv"))
    cv2.imwrite(str(empty), np.full((80, 120), 90, np.uint8))
    broken.write_bytes(b"no picture")
    pictures = (lines[0], empty, broken, lines[1])
    drawn = tmp_path / "drawn"
    result = crenel("extract", *pictures, "-o", table, "--draw", drawn)
    assert result.exit_code == 3
    reasons = result.stdout.split("\n")
    assert any(line.startswith(f"{empty} shows no laser stripe") for line in reasons)
    assert any(line.startswith(str(broken)) for line in reasons)
    assert result.stderr.endswith("crenel: 2 of 4 pictures have no line\n")
    named = [row["image"] for row in rows_of(table)]
    assert named == [str(lines[0])] * 120 + [str(lines[1])] * 120
    names = ["empty.png", "first.png", "last.png"]  # of the empty one, why it has none
    assert sorted(path.name for path in drawn.iterdir()) == names
    result = crenel("extract", *pictures, "-o", table, "--json")
    assert result.exit_code == 3
    found = json.loads(result.stdout)["images"]
    assert [len(one["u"]) for one in found] == [120, 0, 0, 120]
    codes = [one["refusal"] and one["refusal"]["code"] for one in found]
    assert codes == [None, "stripe-not-found", "image-unreadable", None]


def test_nothing_is_written_where_no_picture_has_a_line(tmp_path: Path) -> None:
    empty, table = write_blank(tmp_path / "empty.png", 80, 120), tmp_path / "s.csv"
    result = crenel("extract", empty, empty, "-o", table)
    assert result.exit_code == 1
    assert "none of the 2 pictures has any line" in result.stderr
    result = crenel("extract", empty, "-o", table)
    assert result.exit_code == 1
    assert "shows no laser stripe" in result.stderr
    assert not table.exists()


@pytest.mark.parametrize(("axis", "other"), [("u", "v"), ("v", "u")])
def test_a_line_along_the_other_axis_is_said(tmp_path: Path, axis: str, other: str) -> None:
    rows = np.arange(300.0)[:, None]
    steep = 20 + 150 * np.exp(-((np.arange(400.0) - 150 - 0.2 * rows) ** 2) / 4.5)
    noise = np.random.default_rng(0).normal(0, 1.0, steep.shape)
    picture = (steep + noise).round().astype(np.uint8)
    path, table = tmp_path / "line.png", tmp_path / "s.csv"
    cv2.imwrite(str(path), picture if axis == "u" else picture.T)
    said = crenel("extract", path, path, "-o", table, "--axis", axis).output
    assert f"Give --axis {other}" in " ".join(said.split())
    assert "--axis" not in done("extract", path, path, "-o", table, "--axis", other).output


def test_a_picture_that_cannot_be_read_leaves_the_others(tmp_path: Path, board: Path) -> None:
    seen, broken = picture(tmp_path / "seen.png"), tmp_path / "broken.png"
    broken.write_bytes(seen.read_bytes()[:500])
    table, drawn = tmp_path / "corners.csv", tmp_path / "drawn"
    result = crenel("detect", seen, broken, "--object", board, "-o", table, "--draw", drawn)
    assert result.exit_code == 3
    assert f"{broken} ends after 500 bytes" in result.stdout
    assert result.stderr.endswith("crenel: 1 of 2 pictures have no corners\n")
    rows = rows_of(table)
    assert [row["image"] for row in rows] == [str(seen)] * 20 + [str(broken)]
    assert rows[-1]["refusal"] == "image-cut-off"
    assert [path.name for path in drawn.iterdir()] == ["seen.png"]
    table.unlink()
    result = crenel("detect", broken, broken, "--object", board, "-o", table)
    assert result.exit_code == 1
    assert not table.exists()


@pytest.mark.parametrize("command", ["extract", "detect"])
@pytest.mark.parametrize(
    ("shown", "status"),
    [
        ("s", 0),
        ("ss", 0),
        ("se", 3),
        ("sb", 3),
        ("seb", 3),
        ("e", 1),
        ("ee", 1),
        ("eb", 1),
        ("b", 1),
    ],
)
def test_the_status_says_how_many_pictures_give_something(
    tmp_path: Path, board: Path, command: str, shown: str, status: int
) -> None:
    """Pictures that show it (s), are empty (e) or broken (b)."""
    files = [tmp_path / f"{i}{kind}.png" for i, kind in enumerate(shown)]
    for file in files:
        kind = file.stem[-1]
        if kind == "e":
            write_blank(file, 200, 200)
        else:
            (picture if command == "detect" else write_line)(file)
        if kind == "b":
            file.write_bytes(file.read_bytes()[:500])
    table = tmp_path / "table.csv"
    options = () if command == "extract" else ("--object", board)
    assert crenel(command, *files, *options, "-o", table).exit_code == status
    assert table.exists() == ("s" in shown)


def write_raw(path: Path) -> Path:
    cv2.imwrite(str(path), mosaic(expose(render_colours("red", 6.0), seed=1), "GRBG"))
    return path


def test_raw_pictures_are_measured_at_the_pixels_of_the_lasers_colour(tmp_path: Path) -> None:
    raw = write_raw(tmp_path / "raw.png")
    table, drawn = tmp_path / "stripe.csv", tmp_path / "drawn"
    options = ("--bayer", "GRBG", "--colour", "red")
    document = {"format": "crenel/mask", "version": 1, "width_px": WIDTH, "height_px": HEIGHT}
    left = [[0, 0], [99, 0], [99, 319], [0, 319]]
    mask = tmp_path / "mask.json"
    mask.write_text(json.dumps({**document, "zones": [left]}))
    result = done("extract", raw, "-o", table, *options, "--mask", mask, "--draw", drawn)
    assert "red pixels of GRBG" in result.stdout
    u, v, _, sigma = np.loadtxt(table, delimiter=",", skiprows=1, unpack=True)
    assert u.min() == 101
    assert set(np.diff(u)) == {2.0}
    assert float(np.sqrt(np.mean((v - line_rows(u)) ** 2))) < 0.06
    assert 0.03 < float(np.median(sigma)) < 0.06
    image = present(cv2.imread(str(drawn / "raw.png")))
    assert image.shape[0] > HEIGHT  # in words, what took the line
    assert image.shape[1:] == (WIDTH, 3)
    found = printed("extract", raw, "-o", table, *options)
    assert found["images"][0]["channel"] == "red pixels of GRBG"
    assert crenel("extract", raw, "-o", table, "--bayer", "GRBG").exit_code == 2
    cv2.imwrite(str(raw), expose(render_colours("red", 6.0), seed=1))
    assert "is in colour: a raw Bayer picture" in refused("extract", raw, "-o", table, *options)


def test_raw_pictures_that_are_not_called_raw_are_warned_of(tmp_path: Path, board: Path) -> None:
    raw, off = write_raw(tmp_path / "raw.png"), tmp_path / "off.png"
    cv2.imwrite(str(off), mosaic(expose(render_colours({}, 6.0), seed=1), "GRBG"))
    table = tmp_path / "stripe.csv"
    found = crenel("extract", raw, "-o", table, "--json")
    assert "in 1 pictures, the pixels alternate" in found.stderr
    assert json.loads(found.stdout)["images"][0]["looks_raw"]
    said = refused("extract", off, "-o", table)
    assert "shows no laser stripe: the pixels alternate" in said
    assert "--bayer" in said
    stated = crenel("extract", raw, "-o", table, "--bayer", "GRBG", "--colour", "red")
    assert "alternate" not in stated.output
    assert "alternate as in a raw" in crenel("detect", raw, "--object", board).stdout


def test_corners_of_raw_pictures_are_in_their_pixels(tmp_path: Path, board: Path) -> None:
    seen = picture(tmp_path / "seen.png")
    grey = present(cv2.imread(str(seen), cv2.IMREAD_GRAYSCALE))
    dimmer = (grey[..., None] * np.array([0.6, 1.0, 0.8])).astype(np.uint8)
    cv2.imwrite(str(seen), mosaic(dimmer, "BGGR"))
    table = tmp_path / "corners.csv"
    for colour in ("red", "green", "blue"):
        options = ("--bayer", "BGGR", "--colour", colour)
        done("detect", seen, "--object", board, "-o", table, *options)
        u = sorted(float(row["u"]) for row in rows_of(table))
        np.testing.assert_allclose(u, np.repeat(99.5 + 40 * np.arange(5), 4), atol=0.25)


def test_channels_are_weighed_by_a_picture_with_the_laser_off(tmp_path: Path) -> None:
    lit, unlit, table = (tmp_path / name for name in ("lit.png", "unlit.png", "stripe.csv"))
    cv2.imwrite(str(lit), expose(render_colours({"red": 1.0, "green": 0.4}, 6.0), seed=1))
    cv2.imwrite(str(unlit), expose(render_colours({}, 6.0), seed=2))
    (found,) = printed("extract", lit, "-o", table, "--laser-off", unlit)["images"]
    green, red = found["channel"].split(" + ")
    assert float(green.removesuffix(" green")) == pytest.approx(0.28, abs=0.05)
    assert float(red.removesuffix(" red")) == pytest.approx(0.72, abs=0.05)
    both = ("--laser-off", unlit, "--colour", "red")
    assert crenel("extract", lit, "-o", table, *both).exit_code == 2
    assert "not brighter" in crenel("extract", unlit, "-o", table, "--laser-off", unlit).stderr


def test_grey_pictures_are_measured_less_what_they_show_with_the_laser_off(tmp_path: Path) -> None:
    """A line that is dimmer than the stripes of the room, at another place in two pictures."""
    rng = np.random.default_rng(5)
    v = np.arange(240)[:, None] + np.zeros((240, 320))
    room = 60 + 90 * (np.sin(v / 7) > 0.2)
    files = []
    for name, row in (("unlit", None), ("a", 100.3), ("b", 131.6)):
        line = 0 if row is None else 35 * np.exp(-0.5 * ((v - row) / 2) ** 2)
        files.append(tmp_path / f"{name}.png")
        grey = room + line + rng.normal(0, 1.0, room.shape)
        cv2.imwrite(str(files[-1]), np.clip(np.rint(grey), 0, 255).astype(np.uint8))
    unlit, *lit = files
    shown = printed("extract", *lit, "-o", tmp_path / "stripe.csv", "--laser-off", unlit)["images"]
    for found, row in zip(shown, (100.3, 131.6), strict=True):
        assert found["channel"] == "grey, less the picture with the laser off"
        assert len(found["v"]) > 310
        assert float(np.abs(np.median(found["v"]) - row)) < 0.05
        assert 30 < float(np.median(found["intensity"])) < 40
    without = crenel("extract", *lit, "-o", tmp_path / "stripe.csv")
    assert without.exit_code == 1


def test_a_drawing_shows_what_took_and_left_pieces(tmp_path: Path) -> None:
    """A refused picture is drawn, too."""
    rng = np.random.default_rng(3)
    v = np.arange(200)[:, None] + np.zeros((200, 320))
    dim = 14 * np.exp(-0.5 * ((v - 60) / 2) ** 2) * (np.arange(320) % 90 < 40)
    grey = 20 + dim + rng.normal(0, 1.0, v.shape) + 120 * (rng.random(v.shape) > 0.97)
    grey = np.clip(np.rint(cv2.GaussianBlur(grey, (0, 0), 1.0)), 0, 255).astype(np.uint8)
    seen, folder = tmp_path / "seen.png", tmp_path / "drawn"
    cv2.imwrite(str(seen), grey)
    refused("extract", seen, "-o", tmp_path / "stripe.csv", "--draw", folder)
    drawn = cv2.imread(str(folder / "seen.png"))
    assert drawn is not None
    coloured = np.ptp(drawn.astype(int), axis=2) > 40
    assert coloured[:200].any()
    (why,) = (one.why for one in extract_stripes([seen], "u", explains=True))
    assert why is not None
    assert LINE_REASONS.index(why.decision) >= LINE_REASONS.index("no-points")
    assert {PIECE_REASONS[reason] for reason in why.left} <= {"dim", "ghost", "no-line"}
