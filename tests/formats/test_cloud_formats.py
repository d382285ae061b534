"""Every format a cloud is written in: read back here and by others, in pieces, refused clearly."""

import sys
from pathlib import Path

import laspy
import numpy as np
import pye57
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from crenel.errors import OperationError
from crenel.formats.clouds import pcd
from crenel.formats.clouds.files import CHUNK_POINTS, POINT, SUFFIXES, cloud_writer, read_cloud
from crenel.formats.clouds.xyz import XyzSink
from crenel.metrology.sensor.camera import project
from crenel.metrology.sensor.triangulation import scan_points, sensor_points
from tests.formats.builders import little_calibration, stripe_points

pytestmark = pytest.mark.usefixtures("variant")

STEP_MM = {".ply": 0.0, ".pcd": 1.3e-4, ".e57": 1e-9, ".xyz": 0.51e-4, ".las": 0.51e-4}
STEP_MM[".laz"] = STEP_MM[".las"]
PIECES = (300, 0, 1, CHUNK_POINTS + 5, 70)


def written(path: Path) -> np.ndarray:
    rng = np.random.default_rng(1)
    pieces = []
    with cloud_writer(path) as cloud:
        for frame, count in enumerate(PIECES):
            points = rng.uniform(-1900, 1900, (count, 3))
            intensity = rng.integers(0, 4095, count).astype(float)
            spread = rng.uniform(0.5, 90, count).astype(np.float32).astype(float)
            cloud.write(points, intensity, spread, frame)
            pieces.append(np.column_stack([points, intensity, spread, np.full(count, frame)]))
        assert cloud.points == sum(PIECES)
    return np.concatenate(pieces)


@pytest.mark.parametrize("suffix", SUFFIXES)
def test_what_is_written_reads_back(tmp_path: Path, suffix: str) -> None:
    path = tmp_path / f"cloud{suffix}"
    table = written(path)
    assert [entry.name for entry in tmp_path.iterdir()] == [path.name]
    cloud = read_cloud(path)
    np.testing.assert_allclose(cloud.points_mm, table[:, :3], rtol=0, atol=STEP_MM[suffix])
    np.testing.assert_array_equal(cloud.intensity, table[:, 3])
    assert cloud.uncertainty_um is not None
    np.testing.assert_allclose(cloud.uncertainty_um, table[:, 4], rtol=0, atol=0.0051)
    np.testing.assert_array_equal(cloud.frame, table[:, 5])


def test_e57_is_in_metres_to_others_with_its_bounds(tmp_path: Path) -> None:
    table = written(tmp_path / "c.e57")
    with pye57.E57(str(tmp_path / "c.e57")) as file:
        data = file.read_scan(0, intensity=True, ignore_missing_fields=True)
        header = file.get_header(0)
        bounds = header.cartesianBounds
        assert bounds["xMaximum"].value() == table[:, 0].max() / 1000
        assert header.intensityMaximum == table[:, 3].max()
    np.testing.assert_allclose(data["cartesianY"], table[:, 1] / 1000, rtol=0, atol=1e-12)


@pytest.mark.parametrize("suffix", [".las", ".laz"])
def test_las_is_whole_to_others(tmp_path: Path, suffix: str) -> None:
    table = written(tmp_path / f"c{suffix}")
    las = laspy.read(tmp_path / f"c{suffix}")
    assert str(las.header.version) == "1.4"
    np.testing.assert_allclose(np.asarray(las.z), table[:, 2], rtol=0, atol=0.51e-4)
    np.testing.assert_array_equal(np.asarray(las.frame), table[:, 5])
    np.testing.assert_allclose(las.header.maxs, table[:, :3].max(axis=0), rtol=0, atol=0.51e-4)


@pytest.mark.parametrize("suffix", [".las", ".laz"])
def test_withheld_points_of_las_are_left_out(tmp_path: Path, suffix: str) -> None:
    table = written(tmp_path / f"c{suffix}")[::1000]
    las = laspy.LasData(laspy.LasHeader(point_format=1, version="1.2"))
    las.x, las.y, las.z = table[:, :3].T
    las.withheld = np.arange(len(table)) % 5 == 0
    las.write(tmp_path / f"c{suffix}")
    cloud = read_cloud(tmp_path / f"c{suffix}")
    assert len(cloud.points_mm) + cloud.left_out.deleted == len(table)
    assert cloud.left_out.deleted == np.ceil(len(table) / 5)


def test_pcd_of_others_is_read(tmp_path: Path) -> None:
    points = np.random.default_rng(2).uniform(-9, 9, (20, 3)).astype(np.float32)
    head = "VERSION .7\nFIELDS x y z _ n\nSIZE 4 4 4 1 4\nTYPE F F F U F\nCOUNT 1 1 1 4 3\n"
    head += "WIDTH 20\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS 20\nDATA "
    rows = np.zeros(20, [("p", "<f4", 3), ("_", "u1", 4), ("n", "<f4", 3)])
    rows["p"] = points
    (tmp_path / "b.pcd").write_bytes(head.encode() + b"binary\n" + rows.tobytes())
    np.testing.assert_array_equal(read_cloud(tmp_path / "b.pcd").points_mm, points)
    lines = [" ".join(f"{c:.9g}" for c in p) + " 0 0 0 0 1 2 3" for p in points]
    (tmp_path / "a.pcd").write_text(head + "ascii\n" + "\n".join(lines) + "\n")
    np.testing.assert_allclose(read_cloud(tmp_path / "a.pcd").points_mm, points, rtol=1e-8)
    (tmp_path / "c.pcd").write_text(head + "zipped\n")
    with pytest.raises(OperationError, match="zipped"):
        read_cloud(tmp_path / "c.pcd")


def test_pcd_as_pcl_compresses_it_is_read(tmp_path: Path) -> None:
    points = np.random.default_rng(2).uniform(-9, 9, (500, 3)).astype(np.float32)
    points[100:300, 2] = 7.0
    head = "VERSION .7\nFIELDS x y z label\nSIZE 4 4 4 2\nTYPE F F F U\nCOUNT 1 1 1 2\n"
    head += "WIDTH 500\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS 500\nDATA binary_compressed\n"
    plain = points.T.tobytes() + np.arange(1000, dtype="<u2").tobytes()
    packed = compress_lzf(plain)
    assert len(packed) < len(plain)
    sizes = np.array([len(packed), len(plain)], "<u4").tobytes()
    path = tmp_path / "c.pcd"
    path.write_bytes(head.encode() + sizes + packed)
    np.testing.assert_array_equal(read_cloud(path).points_mm, points)
    damaged = bytearray(packed)
    damaged[0] = 0xFF  # a copy of what was never written
    for sizes_and_data in (
        sizes + packed[:-1],
        sizes[:5],
        sizes + bytes(damaged),
        np.array([len(packed), 1 << 31], "<u4").tobytes() + packed,
    ):
        path.write_bytes(head.encode() + sizes_and_data)
        with pytest.raises(OperationError, match=r"c\.pcd"):
            read_cloud(path)


def compress_lzf(plain: bytes) -> bytes:
    """As LZF has it: copies of three bytes or more that stood before, and literal bytes."""
    packed, literals, at = bytearray(), bytearray(), 0
    seen: dict[bytes, int] = {}

    def flush() -> None:
        for begin in range(0, len(literals), 32):
            part = literals[begin : begin + 32]
            packed.append(len(part) - 1)
            packed.extend(part)
        literals.clear()

    while at < len(plain):
        back = at - seen.get(plain[at : at + 3], at)
        seen[plain[at : at + 3]] = at
        if not 0 < back <= 8192 or at + 3 > len(plain):
            literals.append(plain[at])
            at += 1
            continue
        count, most = 3, min(264, len(plain) - at)
        while count < most and plain[at + count - back] == plain[at + count]:
            count += 1
        flush()
        length = count - 2
        packed.append((min(length, 7) << 5) + ((back - 1) >> 8))
        if length >= 7:
            packed.append(length - 7)
        packed.append((back - 1) & 255)
        at += count
    flush()
    return bytes(packed)


@given(packed=st.binary(max_size=200), wanted=st.integers(0, 2000))
@settings(deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture])
def test_foreign_bytes_never_expand_beyond_what_is_wanted(packed: bytes, wanted: int) -> None:
    guarded = np.full(wanted + 64, 170, np.uint8)
    done = pcd._expand_lzf(np.frombuffer(packed, np.uint8), guarded[:wanted])
    assert done in (0, 1)
    assert (guarded[wanted:] == 170).all()


@pytest.mark.parametrize("suffix", SUFFIXES)
def test_a_cut_cloud_is_refused(tmp_path: Path, suffix: str) -> None:
    path = tmp_path / f"c{suffix}"
    written(path)
    whole = path.read_bytes()
    if suffix == ".xyz":  # only its last line shows the damage
        path.write_bytes(whole[: whole.rindex(b" ") - 20])
    else:
        path.write_bytes(whole[: len(whole) // 2])
    with pytest.raises(OperationError, match=rf"c\{suffix}"):
        read_cloud(path)


@pytest.mark.parametrize(
    ("suffix", "far_mm"), [(".pcd", 2e4), (".las", 3e5), (".laz", 3e5), (".xyz", 2e9)]
)
def test_what_a_format_cannot_hold_is_refused(tmp_path: Path, suffix: str, far_mm: float) -> None:
    path = tmp_path / f"c{suffix}"
    path.write_bytes(b"what stood there before")

    def write() -> None:
        ones = np.ones(CHUNK_POINTS)
        with cloud_writer(path) as cloud:
            for i in range(3):
                cloud.write(np.full((CHUNK_POINTS, 3), far_mm * (i == 2)), ones, ones, i)

    with pytest.raises(OperationError, match="a point lies at"):
        write()
    assert path.read_bytes() == b"what stood there before"
    assert len(list(tmp_path.iterdir())) == 1


def test_an_unknown_suffix_is_refused_before_the_work(tmp_path: Path) -> None:
    with pytest.raises(OperationError, match=r"\.ply, \.pcd"), cloud_writer(tmp_path / "c.stl"):
        pass
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize(
    ("suffix", "name", "extra"),
    [(".e57", "pye57", "clouds"), (".laz", "laspy", "clouds"), (".copc.laz", "copclib", "copc")],
)
def test_a_library_that_is_missing_is_named(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, suffix: str, name: str, extra: str
) -> None:
    monkeypatch.setitem(sys.modules, name, None)
    with (
        pytest.raises(OperationError, match=rf"{name}.*crenel\[{extra}\]"),
        cloud_writer(tmp_path / f"c{suffix}"),
    ):
        pass
    assert not list(tmp_path.iterdir())


def test_text_has_the_numbers_to_their_last_digit(tmp_path: Path) -> None:
    rng = np.random.default_rng(3)
    points = np.zeros(500, POINT)
    for axis in "xyz":
        points[axis] = rng.choice([1e-5, 1e-3, 1.0, 1e4], 500) * rng.normal(0, 1, 500)
    points["intensity"], points["uncertainty_um"] = rng.uniform(0, 255, (2, 500))
    points["frame"] = rng.integers(0, 10**9, 500)
    with open(tmp_path / "c.xyz", "wb") as file:
        XyzSink(tmp_path / "c.xyz", file).write(points)
    lines = (tmp_path / "c.xyz").read_text().splitlines()[1:]
    for line, point in zip(lines, points, strict=True):
        x, y, z, intensity, uncertainty_um, frame = line.split(" ")
        for text, axis in ((x, "x"), (y, "y"), (z, "z")):
            digits = f"{point[axis]:.4f}"
            assert text in (digits, digits.replace("-0.0000", "0.0000"))
        assert abs(float(intensity) - point["intensity"]) <= 0.0501
        assert abs(float(uncertainty_um) - point["uncertainty_um"]) <= 0.00501
        assert int(frame) == point["frame"]


@pytest.mark.parametrize("axis", ["u", "v"])
def test_a_points_uncertainty_is_the_stripes_seen_from_there(axis: str) -> None:
    """Against pixels moved by their standard deviation and reconstructed again."""
    use = little_calibration()
    _, uv = stripe_points()
    sigma = np.linspace(0.02, 0.3, len(uv))
    step = np.array([0.0, 1.0]) if axis == "u" else np.array([1.0, 0.0])
    half = 0.5 * sigma[:, None] * step
    moved = [sensor_points(use.camera, use.plane, uv + sign * half) for sign in (1, -1)]
    points = sensor_points(use.camera, use.plane, uv)
    np.testing.assert_allclose(project(use.camera, points), uv, atol=1e-9)
    expected = 1e3 * np.linalg.norm(moved[0] - moved[1], axis=1)
    count, pose = np.array([len(uv)]), np.eye(4)[None]
    same, spread_um = scan_points(
        use.camera, use.plane, uv[:, 0], uv[:, 1], sigma, axis, count, pose
    )
    np.testing.assert_allclose(same, points, atol=1e-12)
    np.testing.assert_allclose(spread_um, expected, rtol=1e-5)
