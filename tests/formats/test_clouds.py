"""Clouds: PLY as others read it, PLY as others write it, XYZ text."""

from pathlib import Path

import numpy as np
import pytest
import trimesh
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from crenel.errors import OperationError
from crenel.formats.clouds.files import cloud_writer, read_cloud
from crenel.metrology.transforms import Floats
from tests.refusals import refused_as

POINTS = np.random.default_rng(3).uniform(-1000, 1000, (257, 3))


def write_pieces(path: Path, sizes: list[int]) -> Floats:
    """Writes pieces of so many points, each with its number as frame, and gives the points."""
    rng, pieces = np.random.default_rng(4), []
    with cloud_writer(path) as cloud:
        for frame, size in enumerate(sizes):
            points = rng.uniform(-1000, 1000, (size, 3))
            cloud.write(points, np.full(size, 50.0), np.full(size, 0.1), frame)
            pieces.append(points)
    return np.concatenate(pieces)


def ascii_ply(*lines: str) -> bytes:
    """The header of a PLY file in text."""
    return "\n".join(["ply", "format ascii 1.0", *lines, "end_header\n"]).encode()


def of_points(count: int, content: bytes) -> bytes:
    """A PLY file in text with coordinates alone."""
    axes = (f"property float {axis}" for axis in "xyz")
    return ascii_ply(f"element vertex {count}", *axes) + content


@given(st.lists(st.integers(0, 300), min_size=1, max_size=6))
@settings(max_examples=30, suppress_health_check=[HealthCheck.function_scoped_fixture])
def test_pieces_read_back_here_and_elsewhere(tmp_path: Path, sizes: list[int]) -> None:
    path = tmp_path / "cloud.ply"
    sizes = [*sizes, 1]
    points = write_pieces(path, sizes)
    cloud = read_cloud(path)
    np.testing.assert_array_equal(cloud.points_mm, points)
    assert cloud.frame is not None
    np.testing.assert_array_equal(cloud.frame, np.repeat(np.arange(len(sizes)), sizes))
    elsewhere = trimesh.load(path)
    assert isinstance(elsewhere, trimesh.PointCloud)
    np.testing.assert_array_equal(np.asarray(elsewhere.vertices), points)


def test_points_that_are_none_are_left_out(tmp_path: Path) -> None:
    points = POINTS[:5].copy()
    points[1, 2] = np.nan
    points[3] = np.inf
    with cloud_writer(tmp_path / "c.ply") as cloud:
        cloud.write(points, np.arange(5.0), np.zeros(5), 7)
        assert cloud.points == 3
    back = read_cloud(tmp_path / "c.ply")
    np.testing.assert_array_equal(back.points_mm, points[[0, 2, 4]])
    np.testing.assert_array_equal(back.intensity, [0, 2, 4])


def test_the_header_says_what_is_in_it(tmp_path: Path) -> None:
    write_pieces(tmp_path / "c.ply", [3, 4])
    header = (tmp_path / "c.ply").read_bytes().split(b"end_header\n")[0].decode()
    assert header.startswith("ply\nformat binary_little_endian 1.0\n")
    assert "element vertex 7\nproperty double x\nproperty double y\nproperty double z\n" in header
    assert "property float intensity\n" in header
    assert "property int frame\n" in header


@pytest.mark.parametrize("encoding", ["ascii", "binary"])
def test_clouds_written_elsewhere_are_read(tmp_path: Path, encoding: str) -> None:
    path = tmp_path / "c.ply"
    path.write_bytes(trimesh.exchange.ply.export_ply(trimesh.PointCloud(POINTS), encoding=encoding))
    np.testing.assert_allclose(read_cloud(path).points_mm, POINTS, atol=1e-4)  # float, there


@pytest.mark.parametrize("order", ["<", ">"])
def test_any_order_of_properties_and_bytes(tmp_path: Path, order: str) -> None:
    fields = [("red", "u1"), ("z", "f8"), ("frame", "u2"), ("x", "f4"), ("q", "i4"), ("y", "f8")]
    table = np.zeros(len(POINTS), [(name, order + kind) for name, kind in fields])
    for i, axis in enumerate("xyz"):
        table[axis] = POINTS[:, i]
    table["frame"] = np.arange(len(POINTS))
    names = {"u1": "uchar", "f8": "float64", "u2": "ushort", "f4": "float", "i4": "int32"}
    lines = [
        "ply",
        f"format binary_{'little' if order == '<' else 'big'}_endian 1.0",
        "comment made manually",
        "element camera 2",
        "property short a",
        "property double b",
        f"element vertex {len(POINTS)}",
        *(f"property {names[kind]} {name}" for name, kind in fields),
        "element face 1",
        "property list uchar int vertex_indices",
        "end_header\r",
    ]
    content = "\r\n".join(lines).encode() + b"\n" + bytes(2 * 10) + table.tobytes() + bytes(13)
    (tmp_path / "c.ply").write_bytes(content)
    cloud = read_cloud(tmp_path / "c.ply")
    np.testing.assert_allclose(cloud.points_mm, POINTS, atol=1e-4)
    np.testing.assert_array_equal(cloud.points_mm[:, 1:], POINTS[:, 1:])
    np.testing.assert_array_equal(cloud.frame, np.arange(len(POINTS)))


@pytest.mark.parametrize("separator", [" ", "\t", ",", "; "])
@pytest.mark.parametrize("head", ["", "# a comment\n", "x y z intensity\n", "\ufeff"])
def test_xyz_text_is_read(tmp_path: Path, separator: str, head: str) -> None:
    rows = [separator.join([*(f"{c:.17g}" for c in point), "17"]) for point in POINTS]
    path = tmp_path / "c.xyz"
    path.write_text(head.replace(" ", separator) + "\n".join(rows) + "\n", encoding="utf-8")
    np.testing.assert_array_equal(read_cloud(path).points_mm, POINTS)


@pytest.mark.parametrize("separator", [" ", "\t", ";", "; "])
@pytest.mark.parametrize("head", ["", "x y z intensity\n"])
def test_decimal_commas_are_read_in_text(tmp_path: Path, separator: str, head: str) -> None:
    rows = [separator.join(["-1,25", "3e-2", "7", "17"]), separator.join(["1,5", "2", "0,5", "9"])]
    text = head.replace(" ", separator) + "\n".join(rows) + "\n"
    (tmp_path / "c.xyz").write_text(text)
    points = read_cloud(tmp_path / "c.xyz").points_mm
    np.testing.assert_array_equal(points, [[-1.25, 0.03, 7], [1.5, 2, 0.5]])
    (tmp_path / "c.ply").write_bytes(of_points(1, b"1,5 2,5 3\n"))
    with refused_as("cloud-decimal-commas", "c.ply", "decimal points"):
        read_cloud(tmp_path / "c.ply")


@pytest.mark.parametrize("separator", [" ", ",", ";"])
@pytest.mark.parametrize("start", ["", "//", "# "])
def test_columns_named_above_points_are_found(tmp_path: Path, separator: str, start: str) -> None:
    rows = [separator.join(["7", *(f"{c:.17g}" for c in point)]) for point in POINTS[:, ::-1]]
    path = tmp_path / "c.xyz"
    path.write_text("\n".join([start + separator.join(["id", "Z", "Y", "X"]), *rows]) + "\n")
    np.testing.assert_array_equal(read_cloud(path).points_mm, POINTS)


X, ONE = "property float x", "element vertex 1"
FACES = ("element face 1", "property list uchar int i")


@pytest.mark.parametrize(
    ("content", "said"),
    [
        (b"", "empty"),
        (b"\n\n", "empty"),
        (b"x y z\n", "no points"),
        (b"1 2\n3 4\n", "x y z"),
        (b"1 2 3\n4 5 hello\n", "hello"),
        (b"1 2 3\n4 5e200 6\n", "5e\\+200 mm"),
        (b"\x00\x01\x02", "not a cloud of a known format"),
        (b"ply\nformat ascii 1.0\n", "does not end"),
        (b"ply\nformat morse 1.0\nend_header\n", "format"),
        (ascii_ply(), "no element vertex"),
        (ascii_ply("element vertex many"), "many"),
        (ascii_ply(X), "property float x"),
        (ascii_ply(ONE, X) + b"1\n", "no y, z"),
        (ascii_ply(ONE, X, X) + b"1 2\n", "two properties with the same name"),
        (ascii_ply(*FACES, ONE, X), "no y, z"),
        (ascii_ply("element face 0", FACES[1], ONE, X), "no y, z"),
        (ascii_ply(ONE, X, "property list float int view"), "property list float int view"),
    ],
)
def test_what_is_no_cloud_is_refused(tmp_path: Path, content: bytes, said: str) -> None:
    path = tmp_path / "cloud.dat"
    path.write_bytes(content)
    with pytest.raises(OperationError, match=said) as refused:
        read_cloud(path)
    assert str(path) in str(refused.value.what)


def test_a_cut_cloud_is_refused_wherever_it_ends(tmp_path: Path) -> None:
    path = tmp_path / "c.ply"
    write_pieces(path, [100])
    whole = path.read_bytes()
    for length in (len(whole) - 1, len(whole) // 2, 240, 100):
        path.write_bytes(whole[:length])
        with pytest.raises(OperationError, match=r"c\.ply"):
            read_cloud(path)
    path.write_bytes(whole.replace(b"element vertex 100", b"element vertex 999999999999999"))
    with pytest.raises(OperationError, match="100 of 999999999999999"):
        read_cloud(path)


def test_an_ascii_cloud_that_ends_early_is_refused(tmp_path: Path) -> None:
    path = tmp_path / "c.ply"
    path.write_bytes(of_points(3, b"1 2 3\n4 5 6\n"))
    with pytest.raises(OperationError, match="2 of 3 points"):
        read_cloud(path)
    path.write_bytes(of_points(3, b"1 2 3\n4 5 6\n7 8\n"))
    with pytest.raises(OperationError, match=r"c\.ply"):
        read_cloud(path)


NAMES = [
    ("No.,X [mm],Y [mm],Z [mm]", 1.0),
    ('"Intensity","Points:0","Points:1","Points:2"', 1.0),
    ("id;x_m;y_m;z_m", 1000.0),
    ("t\tPosX\tPosY\tPosZ", 1.0),
    ("t POS_X(inch) POS_Y(inch) POS_Z(inch)", 25.4),
    ("Nominal X,Measured X (mm),Measured Y (mm),Measured Z (mm)", 1.0),
    ("Nr;X-Koordinate [µm];Y-Koordinate [µm];Z-Koordinate [µm]", 1e-3),
]


@pytest.mark.parametrize(("names", "mm"), NAMES)
def test_columns_are_found_by_the_names_of_programs(tmp_path: Path, names: str, mm: float) -> None:
    sign = next((sign for sign in ",;\t" if sign in names), " ")
    table = np.column_stack([np.arange(len(POINTS)), POINTS / mm])
    rows = "\n".join(sign.join(map(repr, row)) for row in table.tolist())
    (tmp_path / "c.csv").write_text(f"{names}\n{rows}\n", encoding="utf-8")
    np.testing.assert_allclose(read_cloud(tmp_path / "c.csv").points_mm, POINTS, rtol=1e-12)
    (tmp_path / "c.csv").write_text(rows)
    with refused_as("cloud-columns-unknown", "numbers the points", "--columns 2,3,4"):
        read_cloud(tmp_path / "c.csv")
    given = read_cloud(tmp_path / "c.csv", ("2", "3", "4"), mm)
    np.testing.assert_allclose(given.points_mm, POINTS, rtol=1e-12)


def test_unknown_columns_are_named_and_can_be_given(tmp_path: Path) -> None:
    (tmp_path / "c.csv").write_text("a,north,east,up\n9,1,2,3\n9,4,5,7\n")
    with refused_as("cloud-columns-unknown", "a, north, east, up", "--columns"):
        read_cloud(tmp_path / "c.csv")
    with refused_as("cloud-column-missing", "no column down"):
        read_cloud(tmp_path / "c.csv", ("north", "east", "down"))
    (tmp_path / "m.csv").write_text("x_mm,y_mm,z_cm\n1,2,3\n")
    for columns in (None, ("x_mm", "y_mm", "z_cm")):
        with refused_as("cloud-columns-unknown", "x_mm, y_mm, z_cm have different units"):
            read_cloud(tmp_path / "m.csv", columns)
    found = read_cloud(tmp_path / "c.csv", ("east", "north", "up")).points_mm
    np.testing.assert_array_equal(found, [[2, 1, 3], [5, 4, 7]])
    (tmp_path / "c.pcd").write_text(
        "VERSION .7\nFIELDS rgb Z Y X\nSIZE 4 4 4 4\nTYPE F F F F\nCOUNT 0 1 1 1\n"
        "WIDTH 1\nHEIGHT 1\nDATA ascii\n3 2 1\n"
    )
    np.testing.assert_array_equal(read_cloud(tmp_path / "c.pcd").points_mm, [[1, 2, 3]])


@pytest.mark.parametrize("none", [(0.0, 0.0, 0.0), (-0.0, 0.0, -0.0), (-9999.0, 7.0, 1.5)])
def test_unmeasured_points_are_left_out(tmp_path: Path, none: tuple[float, float, float]) -> None:
    rows = np.concatenate([POINTS[:100], np.tile(none, (300, 1)), POINTS, POINTS[:7]])
    np.savetxt(tmp_path / "c.xyz", rows, fmt="%.17g")
    cloud = read_cloud(tmp_path / "c.xyz")
    np.testing.assert_array_equal(cloud.points_mm, POINTS)
    assert (cloud.left_out.missing, cloud.left_out.repeated) == (300, 107)
    np.savetxt(tmp_path / "c.xyz", np.zeros((5, 3)))
    with refused_as("cloud-empty", "none of its 5 points was measured"):
        read_cloud(tmp_path / "c.xyz")
