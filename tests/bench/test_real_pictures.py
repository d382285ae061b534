"""``python -m tests.bench real``: what it counts, on lines whose truth is known, and its folder."""

import json
from functools import partial
from pathlib import Path

import cv2
import numpy as np
import pytest
from numpy.typing import NDArray
from typer.testing import CliRunner, Result

from crenel.errors import OperationError
from crenel.formats.images import GreyImage
from crenel.metrology.targets.chessboard import Chessboard
from crenel.metrology.transforms import Floats
from tests.bench.commands import bench
from tests.bench.real.agreement import find_agreed, find_false, find_runs
from tests.bench.real.harder import HARDER
from tests.bench.real.layout import LazyPicture, PictureSetNotes, find_sets
from tests.bench.real.lines import measure_lines, measure_no_line, noise_of_columns
from tests.bench.real.peers import PEERS, find_by_peers, measure_width_px
from tests.bench.real.real_pictures import line_table, no_line_table, run
from tests.datasheets import write_object
from tests.present import present

pytestmark = pytest.mark.soak

WIDTH, HEIGHT = 400, 240
Grey = NDArray[np.uint8]


def render_line(
    width_px: float, noise: float = 2.0, seed: int = 0, height: float = 180.0
) -> tuple[Grey, Floats]:
    """A picture with a bent line of a width at half height, and its row in every column."""
    rows = 110 + 30 * np.sin(np.arange(WIDTH) / 90)
    off = np.arange(HEIGHT)[:, None] - rows
    light = 12 + height * np.exp(-0.5 * (2.3548 * off / width_px) ** 2)
    noisy = light + np.random.default_rng(seed).normal(0, noise, light.shape)
    return np.clip(np.rint(noisy), 0, 255).astype(np.uint8), rows


def lazily(*images: GreyImage) -> list[LazyPicture]:
    return [LazyPicture(str(number), partial(np.asarray, one)) for number, one in enumerate(images)]


def saved_line(path: Path, width_px: float) -> None:
    cv2.imwrite(str(path), render_line(width_px)[0])


@pytest.mark.parametrize("width_px", [2.5, 6.0, 15.0, 29.0])
def test_the_peers_find_lines_of_any_width(width_px: float) -> None:
    image, rows = render_line(width_px)
    measured = measure_width_px([image])
    assert measured == pytest.approx(width_px, rel=0.12)
    assert measured is not None
    for name, found in find_by_peers(image, measured).items():
        off = found[30:-30] - rows[30:-30]
        assert np.isfinite(off).all(), name
        assert float(np.sqrt(np.mean(off**2))) < 0.02 * width_px + 0.05, name


@pytest.mark.parametrize("height", [0.0, 300.0])
def test_no_width_is_measured_without_a_line(height: float) -> None:
    """In noise, and of a round spot that clips."""
    v, u = np.mgrid[:HEIGHT, :WIDTH]
    spot = height * np.exp(-0.5 * ((u - 200) ** 2 + (v - 100) ** 2) / 2.5**2)
    noise = np.random.default_rng(3).normal(0, 2, spot.shape)
    image = np.clip(np.rint(12 + spot + noise), 0, 255).astype(np.uint8)
    if height == 0:
        assert measure_width_px([image]) is None
    assert not find_agreed(list(find_by_peers(image, 6.0).values()), 6.0).any()


def test_runs_are_connected_over_small_gaps() -> None:
    rows = np.full(60, np.nan)
    rows[2:20] = 5.0
    rows[8:10] = np.nan
    rows[30:60] = 9.0
    rows[45:] = 80.0
    assert find_runs(rows, 16).nonzero()[0].tolist() == [*range(2, 8), *range(10, 20)]
    assert not find_runs(rows, 17).any()
    assert not find_runs(np.full(5, np.nan), 1).any()


def test_missed_and_false_points_are_counted() -> None:
    rows: dict[str, Floats] = {name: np.full(100, 50.0) for name in ("crenel", *PEERS)}
    rows["crenel"][:10] = np.nan  # missed
    rows["crenel"][20:25] = 56.0  # alone, where the others agree
    rows["crenel"][30:33] = 56.0
    rows["steger"][30:33] = 55.0  # beside another's
    rows["steger"][40:43] = 70.0
    for name in PEERS:
        rows[name][90:] = np.nan  # nothing to be compared with
        rows[name][62:75] = np.nan  # too short a run behind it
    agreed = find_agreed([rows[name] for name in PEERS], 4.0)
    assert (agreed & np.isnan(rows["crenel"])).sum() == 10
    assert agreed.sum() == 62 - 3 - 3
    assert find_false(rows, "crenel", 4.0).nonzero()[0].tolist() == [*range(20, 25)]
    assert find_false(rows, "steger", 4.0).nonzero()[0].tolist() == [*range(40, 43)]


def test_a_spot_that_misleads_the_peers_makes_no_false_point() -> None:
    rows: dict[str, Floats] = {name: np.full(200, 50.0) for name in ("crenel", *PEERS)}
    for name in PEERS:
        rows[name][80:92] = 150.0  # too short for a line
        rows[name][120:150] = 58.0  # a line of its own
    assert find_false(rows, "crenel", 4.0).nonzero()[0].tolist() == [*range(120, 150)]
    rows["crenel"][:] = np.nan
    rows["crenel"][80:92] = 50.0  # and nothing that confirms it
    assert find_false(rows, "crenel", 4.0).nonzero()[0].tolist() == [*range(80, 92)]


def test_noise_is_that_of_the_points_with_gaps_and_outliers() -> None:
    columns = np.arange(4000.0)
    rows = 800 + 1e-4 * (columns - 2000) ** 2
    rows += np.random.default_rng(5).normal(0, 0.08, 4000)
    rows[::7] = np.nan
    rows[100:110] += 40
    left = noise_of_columns(rows)
    assert 1.4826 * float(np.median(np.abs(left))) == pytest.approx(0.08, rel=0.07)
    assert not len(noise_of_columns(np.full(30, np.nan)))


def test_a_line_is_measured_beside_its_peers() -> None:
    frames = [render_line(15.0, seed=seed)[0] for seed in range(8)]
    found = measure_lines("clean", lazily(*frames), PictureSetNotes(repeated=True))
    assert (found.axis, found.pictures, found.with_line) == ("u", 8, 8)
    assert found.missed == 0
    assert found.agreed > 0.95 * 8 * WIDTH
    assert set(found.false.values()) == {0}
    own, theirs = found.noise_px["crenel"], found.noise_px["centroid"]
    assert own is not None
    assert own < present(theirs)
    assert found.sigma_px == pytest.approx(own, rel=0.2)
    assert found.scatter_ratio == pytest.approx(1.0, abs=0.15)
    turned = measure_lines("turned", lazily(*(frame.T for frame in frames[:2])))
    assert (turned.axis, turned.with_line, turned.scatter_ratio) == ("v", 2, None)
    (row,) = line_table([found])
    assert row[6:9] == ["0.0 %", "0", "0"]


def test_pictures_without_a_line_have_no_points() -> None:
    noise = np.random.default_rng(8).normal(20, 2, (HEIGHT, WIDTH))
    image = np.clip(np.rint(noise), 0, 255).astype(np.uint8)
    found = measure_no_line("room", lazily(image))
    assert (found.columns, found.points, found.share) == (WIDTH + HEIGHT, 0, 0.0)
    assert no_line_table([found]) == [["room", "1", str(WIDTH + HEIGHT), "0", "0.00 %"]]
    nothing = measure_lines("nothing", lazily(image))
    assert (nothing.width_px, nothing.agreed, nothing.noise_px) == (None, 0, {})
    assert line_table([nothing])[0][6] == "–"


@pytest.mark.parametrize("name", HARDER)
@pytest.mark.parametrize("kind", [np.uint8, np.uint16])
def test_harder_pictures_still_show_the_line(name: str, kind: type[np.generic]) -> None:
    image, _ = render_line(5.0)
    harder = HARDER[name](image.astype(kind) * (16 if kind is np.uint16 else 1))
    assert harder.dtype in (np.uint8, np.uint16)
    found = measure_lines(name, lazily(harder))
    assert found.agreed > 0.9 * harder.shape[1]


def write_set(folder: Path, **about: object) -> None:
    folder.mkdir(parents=True)
    saved_line(folder / "a.png", 5.0)
    fields = {"format": "crenel/picture-set", "version": 1, **about}
    (folder / "set.json").write_text(json.dumps(fields))


def test_a_folder_is_read_by_its_layout(tmp_path: Path) -> None:
    write_set(tmp_path / "lines" / "dark", no_line=True)
    write_set(tmp_path / "lines" / "two", several=True, width_px=5.0, stripe_axis="u")
    write_set(tmp_path / "boards" / "wall")
    write_set(tmp_path / "boards" / "lit", no_line=False)
    names = [one.name for one in find_sets(tmp_path)]
    assert names == ["boards/lit", "boards/wall", "lines/dark", "lines/two"]
    found = run(tmp_path, harder=False, drawings=tmp_path / "drawn")
    assert (tmp_path / "drawn" / "lines" / "two" / "a, u.png").is_file()
    assert (tmp_path / "drawn" / "boards" / "wall" / "a, v.png").is_file()
    assert [one.name for one in found.no_line] == ["boards/wall", "lines/dark"]
    (two,) = found.lines
    assert (two.name, two.false, two.width_px) == ("lines/two", {}, 5.0)
    assert not found.boards
    assert found.unknown_boards == ["boards/lit", "boards/wall"]
    many = run(tmp_path, harder=True)
    assert len(many.lines) == 1 + len(HARDER)
    halved = next(one for one in many.lines if one.name == "lines/two, half size")
    assert halved.width_px == 2.5


def test_pictures_without_a_folder_for_their_set_are_one_set(tmp_path: Path) -> None:
    saved_line(tmp_path / "a.png", 5.0)
    (lines,) = find_sets(tmp_path)
    assert (lines.kind, lines.board) == ("lines", None)
    board = Chessboard("board", "", (9, 6), 25.0, 0.1)
    write_object(tmp_path / "object.json", board)
    (boards,) = find_sets(tmp_path)
    assert boards.kind == "boards"
    assert present(boards.board).inner_corners == (9, 6)


def test_a_damaged_picture_is_left_out_and_named(tmp_path: Path) -> None:
    (tmp_path / "a").mkdir()
    saved_line(tmp_path / "a/1.png", 6.0)
    (tmp_path / "a/2.png").write_bytes(b"no picture")
    found = run(tmp_path / "a", harder=False)
    assert found.lines[0].pictures == 1
    assert "2.png" in found.unreadable[0]
    coloured = np.dstack([render_line(6.0)[0]] * 2 + [np.full((HEIGHT, WIDTH), 9)])
    cv2.imwrite(str(tmp_path / "a/3.png"), coloured)
    with pytest.raises(OperationError, match="State colour"):
        run(tmp_path / "a", harder=False)


def test_a_wrong_folder_is_refused(tmp_path: Path) -> None:
    with pytest.raises(OperationError, match="boards/SET or lines/SET"):
        find_sets(tmp_path)
    (tmp_path / "lines" / "weld").mkdir(parents=True)
    with pytest.raises(OperationError, match="contains no pictures"):
        find_sets(tmp_path)
    write_set(tmp_path / "boards" / "b")
    saved_line(tmp_path / "lines" / "weld" / "a.png", 5.0)
    (tmp_path / "boards" / "b" / "object.json").write_text("{}")
    with pytest.raises(OperationError, match=r"object\.json"):
        find_sets(tmp_path)


def benched(*words: object) -> Result:
    """What the benchmark of these words prints."""
    return CliRunner().invoke(bench, [str(word) for word in words])


def test_the_command_prints_tables_or_json(tmp_path: Path) -> None:
    write_set(tmp_path / "lines" / "one", stripe_axis="u")
    write_set(tmp_path / "boards" / "wall")
    shown = benched("real", tmp_path)
    assert shown.exit_code == 0, shown.output
    for text in ("Laser lines", "lines/one", "Pictures without a laser line", "boards/wall has no"):
        assert text in shown.stdout
    found = json.loads(benched("real", tmp_path, "--json").stdout)
    assert set(found) == {"boards", "lines", "no_line", "unknown_boards", "unreadable"}
    (line,) = found["lines"]
    assert (line["missed"], line["scatter_ratio"]) == (0, None)
    refused = benched("real", tmp_path / "boards")
    assert "boards/SET or lines/SET" in refused.stderr


def test_a_folder_of_pictures_is_one_set_of_lines(tmp_path: Path) -> None:
    write_set(tmp_path / "one", stripe_axis="u")
    (only,) = find_sets(tmp_path / "one")
    assert (only.name, only.kind, only.about.stripe_axis) == ("lines/one", "lines", "u")


def test_lines_of_a_robots_sensor_are_quieter_than_those_of_peers(real: Path) -> None:
    (pictures,) = find_sets(real / "robot-laser-chessboard" / "calib1")
    about = PictureSetNotes(stripe_axis="v", width_px=18.0)
    line = measure_lines("robot", pictures.pictures()[:2], about)
    noise = present(line.noise_px["crenel"])
    assert noise < 0.03
    assert noise < 0.9 * (line.noise_px["centroid"] or 0.0)
    assert line.missed < 0.02 * line.agreed
