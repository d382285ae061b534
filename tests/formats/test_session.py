"""A session's folder: the samples, round trips, and everything that can be wrong with it."""

from collections.abc import Callable, Iterable
from pathlib import Path

import cv2
import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from crenel.errors import OperationError
from crenel.formats.images import read_grey, write_png
from crenel.formats.session.calibration_session import (
    ContactReadings,
    read_contacts,
    read_session,
    write_contacts,
)
from crenel.formats.session.pose_pictures import ImageRow, write_images
from tests.formats.builders import ARM, BLOCK, HEIGHT, POSE_DEG, WIDTH, edit_text, write_session
from tests.refusals import refused_as


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    return write_session(tmp_path / "s")


def test_a_session_reads(folder: Path) -> None:
    session = read_session(folder)
    assert session.block == BLOCK
    assert session.contacts.features == ("crest", "front", "left")
    np.testing.assert_allclose(session.contacts.q_rad, np.tile(np.deg2rad(POSE_DEG), (3, 1)))
    (pose,) = session.poses
    assert (pose.number, pose.ambient.name) == (0, "a.png")
    assert pose.laser is not None
    np.testing.assert_allclose(pose.q_rad, np.deg2rad(POSE_DEG), rtol=1e-14)


def test_the_samples_read(samples: Path) -> None:
    counts = {}
    for name in ("one-pose", "many-poses", "metal"):
        session = read_session(samples / name)
        counts[name] = (len(session.poses), session.contacts.q_rad.shape)
        assert session.sensor.width_px == 1280
        assert read_grey(session.poses[0].ambient).shape == (1024, 1280)
    assert counts == {"one-pose": (1, (45, 6)), "many-poses": (8, (36, 7)), "metal": (3, (42, 6))}


@given(
    st.lists(
        st.tuples(
            st.sampled_from(("crest", "floor", "front", "back", "left", "right")),
            st.lists(st.floats(-2.9, 2.9), min_size=6, max_size=6),
        ),
        min_size=1,
        max_size=5,
    )
)
@settings(max_examples=40, suppress_health_check=[HealthCheck.function_scoped_fixture])
def test_contacts_read_back(tmp_path: Path, points: list[tuple[str, list[float]]]) -> None:
    q_rad = np.array([angles for _, angles in points])
    if np.abs(np.rad2deg(q_rad)).max() <= 2 * np.pi:
        q_rad[0, 0] = 2.0
    contacts = ContactReadings(tuple(face for face, _ in points), q_rad)
    path = tmp_path / "probing.csv"
    write_contacts(path, contacts)
    back = read_contacts(path, ARM)
    assert back.features == contacts.features
    np.testing.assert_allclose(back.q_rad, q_rad, rtol=4e-16, atol=1e-300)


def test_a_written_session_reads_back(folder: Path) -> None:
    picture = np.random.default_rng(1).integers(0, 65535, (HEIGHT, WIDTH)).astype(np.uint16)
    write_png(folder / "images/both.png", picture)
    q_rad = np.deg2rad(POSE_DEG) + 0.1
    before = read_session(folder).poses[0]
    rows = [
        ImageRow(7, "images/both.png", "both", q_rad),
        ImageRow(0, "images/a.png", "ambient", before.q_rad),
        ImageRow(0, "images/l.png", "laser", before.q_rad),
    ]
    write_images(folder / "images.csv", rows)
    first, last = read_session(folder).poses
    np.testing.assert_allclose(first.q_rad, before.q_rad, rtol=1e-15)
    assert (last.number, last.laser) == (7, None)
    np.testing.assert_array_equal(read_grey(last.ambient), picture)


def test_order_of_columns_blank_lines_bom_and_line_ends_do_not_matter(folder: Path) -> None:
    path = folder / "probing.csv"
    wanted = read_contacts(path, ARM)
    rows = [line.split(",") for line in path.read_text().splitlines()]
    order = [3, 0, 6, 1, 5, 2, 4]
    turned = ["note, " + ", ".join(row[i] for i in order) for row in rows]
    path.write_bytes(("\ufeff\r\n" + "\r\n\r\n".join(turned) + "\r\n,,,,,,,\r\n").encode())
    back = read_contacts(path, ARM)
    assert back.features == wanted.features
    np.testing.assert_array_equal(back.q_rad, wanted.q_rad)


def rewrite(name: str, old: str, new: str) -> Callable[[Path], None]:
    return lambda folder: edit_text(folder / name, old, new)


def replace_lines(
    name: str, change: Callable[[list[str]], Iterable[str]]
) -> Callable[[Path], object]:
    return lambda folder: (folder / name).write_text(
        "\n".join(change((folder / name).read_text().splitlines())) + "\n"
    )


def drop_lines(name: str, keep: int) -> Callable[[Path], object]:
    return replace_lines(name, lambda lines: lines[:keep])


def radians(name: str) -> Callable[[Path], object]:
    in_radians = ",".join(f"{np.deg2rad(angle):.6f}" for angle in POSE_DEG)
    return replace_lines(name, lambda lines: (line.replace(POSE, in_radians) for line in lines))


seven_joints = replace_lines(
    "probing.csv", lambda lines: [f"{lines[0]},q7_deg", *(f"{line},1.0" for line in lines[1:])]
)
WIDER = np.zeros((HEIGHT, WIDTH + 1), np.uint8)
POSE = ",".join(str(angle) for angle in POSE_DEG)
AMBIENT = f"0,images/a.png,ambient,{POSE}\n"
ARABIC = "-\u2068٨٤\u2069"


@pytest.mark.parametrize(
    ("spoil", "code", "said"),
    [
        (lambda s: (s / "arm.json").unlink(), "file-missing", "arm.json"),
        (lambda s: (s / "probing.csv").unlink(), "file-missing", "probing.csv"),
        (lambda s: (s / "images/a.png").unlink(), "image-missing", "images.csv line 2"),
        (lambda s: (s / "probing.csv").write_text(""), "table-empty", "probing.csv"),
        (lambda s: (s / "probing.csv").write_bytes(b"\xff\xfe"), "file-not-text", "UTF-8"),
        (drop_lines("probing.csv", 1), "no-contacts", "no contact"),
        (drop_lines("images.csv", 1), "no-images", "no pictures"),
        (drop_lines("images.csv", 2), "pose-incomplete", "no 'laser' picture"),
        (rewrite("images.csv", ",ambient,", ",laser,"), "image-twice", "line 3"),
        (rewrite("images.csv", AMBIENT, ""), "pose-incomplete", "no 'ambient' picture"),
        (rewrite("images.csv", "0,images/l", "1,images/l"), "pose-incomplete", "pose 0"),
        (rewrite("images.csv", ",ambient,", ",dark,"), "lighting-unknown", "'dark'"),
        (rewrite("images.csv", "0,images/a", "-1,images/a"), "cell-not-a-number", "'-1'"),
        (rewrite("images.csv", "images/a.png", "../a.png"), "image-outside-session", "../a.png"),
        (rewrite("images.csv", "images/a.png", ""), "cell-empty", "column file"),
        (rewrite("images.csv", POSE, POSE.replace("26.25", "26.27")), "pose-moved", "q2_deg"),
        (rewrite("probing.csv", "feature", "face"), "columns-missing", "no column feature"),
        (rewrite("probing.csv", "q3_deg", "q3_rad"), "columns-without-degrees", "in degrees"),
        (rewrite("probing.csv", "q3_deg", "q2_deg"), "columns-twice", "q2_deg"),
        (rewrite("probing.csv", "q6_deg", "q7_deg"), "joint-count", "q1_deg to q6_deg"),
        (rewrite("probing.csv", "crest", "top"), "feature-unknown", "line 2: feature 'top'"),
        (rewrite("probing.csv", "-84.5", "-٨٤"), "cell-not-a-number", f"q3_deg is '{ARABIC}'"),
        (rewrite("probing.csv", "-84.5", "nan"), "cell-not-a-number", "q3_deg is 'nan'"),
        (rewrite("probing.csv", "-84.5", "inf"), "cell-not-a-number", "q3_deg is 'inf'"),
        (rewrite("probing.csv", "-84.5", "8_4"), "cell-not-a-number", "8_4"),
        (rewrite("probing.csv", "-84.5", ""), "cell-empty", "q3_deg"),
        (rewrite("probing.csv", "-84.5", "-84,5"), "row-length", "line 2: 8 cells"),
        (rewrite("probing.csv", ",-84.5", ""), "row-length", "line 2: 6 cells"),
        (rewrite("probing.csv", "-84.5", "-184.5"), "joint-outside-limits", "q3_deg is −184.5"),
        (seven_joints, "joint-count", "7 joint columns"),
        (radians("probing.csv"), "joints-in-radians", "radians, but degrees"),
        (radians("images.csv"), "joints-in-radians", "images.csv"),
        (lambda s: cv2.imwrite(str(s / "images/l.png"), WIDER), "image-size", "65 × 48"),
        (lambda s: (s / "images/l.png").write_text("no"), "image-unreadable", "not a picture"),
        (lambda s: (s / "images/l.png").write_bytes(b""), "image-unreadable", "empty"),
        (rewrite("sensor.json", '"width_px": 64', '"width_px": 65'), "image-size", "64 × 48"),
        (rewrite("sensor.json", '"width_px": 64', '"width_px": 64.5'), "field-invalid", "64.5"),
        (rewrite("sensor.json", '"u"', '"x"'), "field-invalid", "stripe_axis is 'x'"),
    ],
)
def test_a_spoilt_session_is_refused(
    folder: Path, spoil: Callable[[Path], object], code: str, said: str
) -> None:
    spoil(folder)
    with refused_as(code, said, where=folder):
        read_session(folder)


def test_semicolons_are_named(folder: Path) -> None:
    path = folder / "probing.csv"
    path.write_text(path.read_text().replace(",", ";").replace(".", ","))
    with pytest.raises(OperationError, match="not separated by commas"):
        read_contacts(path, ARM)


def test_a_folder_that_is_none_is_refused(tmp_path: Path) -> None:
    (tmp_path / "file").touch()
    for path in (tmp_path / "none", tmp_path / "file"):
        with pytest.raises(OperationError, match=path.name):
            read_session(path)


def test_angles_outside_the_limits_are_refused_but_not_at_the_stop(folder: Path) -> None:
    path = folder / "probing.csv"
    edit_text(path, "-84.5", str(np.rad2deg(-3.0) - 0.4))
    assert len(read_contacts(path, ARM).features) == 3
    edit_text(path, str(np.rad2deg(-3.0) - 0.4), str(np.rad2deg(-3.0) - 0.6))
    with pytest.raises(OperationError, match="is −171"):
        read_contacts(path, ARM)


def test_a_damaged_picture_is_refused_wherever_it_is_damaged(tmp_path: Path) -> None:
    path = tmp_path / "picture.png"
    grey = np.random.default_rng(1).integers(0, 255, (HEIGHT, WIDTH)).astype(np.uint8)
    write_png(path, grey)
    whole = path.read_bytes()
    np.testing.assert_array_equal(read_grey(path), grey)
    for length in (0, 3, 20, 60, len(whole) // 2, len(whole) - 13, len(whole) - 1):
        path.write_bytes(whole[:length])
        with pytest.raises(OperationError, match=r"picture\.png"):
            read_grey(path)
    for place in (20, 100, len(whole) // 2):
        damaged = bytearray(whole)
        damaged[place] ^= 0x10
        path.write_bytes(damaged)
        with pytest.raises(OperationError, match="checksum"):
            read_grey(path)


def test_a_colour_picture_is_read_in_its_lasers_channel(tmp_path: Path) -> None:
    path = tmp_path / "picture.png"
    colours = np.random.default_rng(2).integers(0, 255, (HEIGHT, WIDTH, 3)).astype(np.uint8)
    cv2.imwrite(str(path), colours)
    np.testing.assert_array_equal(read_grey(path, "red"), colours[..., 2])
    np.testing.assert_array_equal(read_grey(path, "green"), colours[..., 1])
    with refused_as("image-in-colour", "laser_wavelength_nm"):
        read_grey(path)


@pytest.mark.parametrize("kind", ["png", "tiff"])
@pytest.mark.parametrize("channels", [3, 4])
def test_a_picture_with_equal_channels_is_grey(tmp_path: Path, kind: str, channels: int) -> None:
    path = tmp_path / f"picture.{kind}"
    grey = np.random.default_rng(2).integers(0, 65535, (HEIGHT, WIDTH)).astype(np.uint16)
    opaque = [np.full_like(grey, 65535)] * (channels - 3)
    cv2.imwrite(str(path), np.dstack([grey] * 3 + opaque))
    np.testing.assert_array_equal(read_grey(path), grey)


@pytest.mark.parametrize("kind", ["tif", "bmp", "pgm", "jpg"])
def test_pictures_of_a_session_may_be_of_any_kind_that_is_read(tmp_path: Path, kind: str) -> None:
    folder = write_session(tmp_path)
    before = read_session(folder).poses[0]
    for path in (folder / "images").glob("*.png"):
        cv2.imwrite(str(path.with_suffix(f".{kind}")), read_grey(path))
        path.unlink()
    table = folder / "images.csv"
    table.write_text(table.read_text().replace(".png", f".{kind}"))
    (pose,) = read_session(folder).poses
    assert pose.files == tuple(file.with_suffix(f".{kind}") for file in before.files)
    smaller = cv2.resize(read_grey(pose.ambient), None, fx=0.5, fy=0.5)
    cv2.imwrite(str(pose.ambient), smaller)
    with refused_as("image-size"):
        read_session(folder)


@pytest.mark.parametrize(
    ("start", "kind"),
    [
        (b"GIF89a", "GIF"),
        (b"\0\0\0\x18ftypheic\0\0\0\0", "HEIC"),
        (b"II*\0\x10\0\0\0CR\2\0", "RAW"),
    ],
)
def test_kinds_of_pictures_not_read_are_named(tmp_path: Path, start: bytes, kind: str) -> None:
    path = tmp_path / "picture"
    path.write_bytes(start + bytes(64))
    with refused_as("image-kind", f"{kind} file", "Save it as PNG"):
        read_grey(path)
