"""Clouds as other programs write them: each kind gives the same points, or the true refusal."""

import io
import struct
from collections.abc import Callable, Iterable
from pathlib import Path

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from crenel.errors import OperationError
from crenel.formats.clouds.files import read_cloud
from crenel.metrology.transforms import Floats
from tests.formats.test_cloud_formats import compress_lzf

COUNT = 60
POINTS = np.round(np.random.default_rng(8).uniform(-900, 900, (COUNT, 3)), 2)
POINTS = POINTS.astype(np.float32).astype(np.float64)
VERTEX = f"element vertex {COUNT}"
AXES = ("property float x", "property float y", "property float z")
LIST = "property list uchar float view"
FACES = ("element face 2", "property list uchar int vertex_indices")
FACE_ROWS = struct.pack("<B3iB4i", 3, 0, 1, 2, 4, 0, 1, 2, 3)
LE, BE = "binary_little_endian", "binary_big_endian"


def text_rows(
    points: Floats = POINTS,
    sign: str = " ",
    start: str = "",
    end: Callable[[int], str] = lambda i: "",
) -> str:
    rows = [sign.join(f"{c:.9g}" for c in point) for point in points]
    return "".join(f"{start}{row}{end(i)}\n" for i, row in enumerate(rows))


def ply(order: str, lines: Iterable[str], body: bytes, newline: str = "\n") -> bytes:
    head = ["ply", f"format {order} 1.0", "comment a", "obj_info b", *lines, "end_header"]
    return (newline.join(head) + newline).encode() + body


def floats(order: str = "<") -> bytes:
    return POINTS.astype(f"{order}f4").tobytes()


def with_lists(order: str, pattern: str) -> bytes:
    """Rows of ``pattern``: p for a point, l for a list, b for a byte."""
    rows = bytearray()
    for i, point in enumerate(POINTS):
        for part in pattern:
            length = i % 4
            rows += {
                "p": struct.pack(f"{order}3f", *point),
                "l": struct.pack(f"{order}B{length}f", length, *range(length)),
                "b": b"\7",
            }[part]
    return bytes(rows)


def pcd(
    body: bytes, data: str = "binary", first: str = "# .PCD v.7\nVERSION .7", **lines: str
) -> bytes:
    head = {
        "FIELDS": "x y z", "SIZE": "4 4 4", "TYPE": "F F F", "COUNT": "1 1 1",
        "WIDTH": str(COUNT), "HEIGHT": "1", "VIEWPOINT": "5 6 7 1 0 0 0", "POINTS": str(COUNT),
    }  # fmt: skip
    written = [f"{key} {value}" for key, value in (head | lines).items() if value]
    return "\n".join([first, *written, f"DATA {data}\n"]).encode() + body


def packed_pcd() -> bytes:
    plain = POINTS.T.astype("<f4").tobytes()
    packed = compress_lzf(plain)
    sizes = struct.pack("<II", len(packed), len(plain))
    lines = {"FIELDS": "x y z _", "SIZE": "4 4 4 1", "TYPE": "F F F U", "COUNT": "1 1 1 4"}
    return pcd(sizes + packed, "binary_compressed", **lines)


TURN, SHIFT = Rotation.from_rotvec([0.3, -0.5, 0.2]).as_matrix(), np.array([1.0, 2.0, 3.0])


def ptx_scan(points_m: Floats, end: str = " 0.5") -> str:
    """Points in the scanner's frame, with its pose, and three cells without a measurement."""
    cells = np.concatenate([(points_m - SHIFT) @ TURN, np.zeros((3, 3))])
    pose = np.vstack([np.column_stack([TURN.T, np.zeros(3)]), [*SHIFT, 1.0]])
    head = [SHIFT, *TURN.T, *pose]
    lines = "".join(" ".join(f"{n:.12g}" for n in line) + "\n" for line in head)
    return f"{len(cells)}\n1\n{lines}" + text_rows(cells, end=lambda i: end)


def stl(name: bytes) -> bytes:
    rows = np.zeros(COUNT // 3, [("normal", "<f4", 3), ("at", "<f4", (3, 3)), ("a", "<u2")])
    rows["at"] = POINTS.reshape(-1, 3, 3)
    return name.ljust(80) + struct.pack("<I", len(rows)) + rows.tobytes()


def saved(*arrays: np.ndarray, **named: np.ndarray) -> bytes:
    file = io.BytesIO()
    if named:
        np.savez_compressed(file, allow_pickle=False, **named)
    else:
        np.save(file, arrays[0])
    return file.getvalue()


def with_fields() -> np.ndarray:
    table = np.zeros(COUNT, [("label", "u1"), ("X", "f4"), ("Y", "f4"), ("Z", "f4")])
    table["X"], table["Y"], table["Z"] = POINTS.T
    return table


HALF = COUNT // 2
PTS = f"{HALF}\n{text_rows(POINTS[:HALF])}{COUNT - HALF}\n{text_rows(POINTS[HALF:])}"
OBJ = (
    "mtllib a\no x\n" + text_rows(start="v ", end=lambda i: "\nvn 0 0 1") + "f -1//-1 1//1 \\\n 2\n"
)
CORNERS = text_rows(start="   vertex ", end=lambda i: "\nendloop\nfacet" if i % 3 == 2 else "")
UPPER = tuple(axis[:-1] + axis[-1].upper() for axis in AXES)
KINDS: dict[str, bytes] = {
    "lists after": ply(LE, [VERTEX, *AXES, LIST, "property uchar q"], with_lists("<", "plb")),
    "lists before": ply(BE, [VERTEX, LIST, "property uchar q", *AXES], with_lists(">", "lbp")),
    "two lists": ply(LE, [VERTEX, LIST, *AXES, LIST + "2"], with_lists("<", "lpl")),
    "lists in text": ply(
        "ascii", [VERTEX, LIST, *AXES], text_rows(start="2 8 9 ", end=lambda i: " 7").encode()
    ),
    "faces first": ply(LE, [*FACES, VERTEX, *AXES], FACE_ROWS + floats()),
    "faces first in text": ply(
        "ascii", [*FACES, VERTEX, *AXES], b"3 0 1 2\n4 0 1 2 3\n" + text_rows().encode()
    ),
    "no faces first": ply(BE, ["element face 0", FACES[1], VERTEX, *UPPER], floats(">")),
    "carriage returns": ply(LE, [VERTEX, *AXES], floats(), "\r"),
    "repeated property": ply(
        LE, [VERTEX, *AXES, "property uchar q", "property uchar q"],
        with_lists("<", "pbb"),
    ),
    "blank line": ply("ascii", [VERTEX, *AXES], text_rows().replace("\n", "\n\n", 1).encode()),
    "upper case": pcd(floats(), FIELDS="X Y Z"),
    "width and height": pcd(floats(), POINTS="", WIDTH=str(HALF), HEIGHT="2"),
    "version .5": pcd(
        text_rows().encode(), "ascii", "# .PCD v.5\nCOLUMNS x y z",
        FIELDS="", SIZE="", TYPE="", COUNT="", VIEWPOINT="", WIDTH="", HEIGHT="",
    ),
    "lower case": pcd(text_rows().encode(), "ASCII", "\n# made by hand").lower(),
    "repeated field": pcd(
        with_lists("<", "pbb"), FIELDS="x y z q q", SIZE="4 4 4 1 1", TYPE="F F F U U",
        COUNT="1 1 1 1 1",
    ),
    "filled up and packed": packed_pcd(),
    "obj": OBJ.encode(),
    "obj with colours": ("# a\r\n\r\ng x\r\n" + text_rows(
        sign="\t", start="v\t", end=lambda i: "\t.5\t.5\t.5\r")).encode(),
    "obj with continued lines": text_rows(sign=" \\\n ", start="v ").encode(),
    "stl": stl(b"a part"),
    "stl named solid": stl(b"solid a"),
    "stl in text": f"solid a\n facet normal 0 0 1\nouter loop\n{CORNERS}endsolid\n".encode(),
    "off": f"OFF # a\n{COUNT} 1 0\n{text_rows()}3 0 1 2\n".encode(),
    "coloured off": f"COFF\n\n{COUNT} 0 0\n{text_rows(end=lambda i: ' 9 9 9 255')}".encode(),
    "ptx": (ptx_scan(POINTS[:HALF] / 1e3) + ptx_scan(POINTS[HALF:] / 1e3, " 0.5 1 2 3")).encode(),
    "pts": PTS.encode(),
    "labels": text_rows(start="P").replace("P", "P1 ").encode(),
    "utf-16": text_rows().encode("utf-16"),
    "npy": saved(np.column_stack([POINTS, POINTS])),
    "npy of rows": saved(POINTS.T),
    "npy of a grid": saved(POINTS.reshape(6, COUNT // 6, 3)),
    "npy of fields": saved(with_fields()),
    "npz": saved(points=POINTS, colors=np.zeros((COUNT, 3), np.uint8)),
    "npz of axes": saved(z=POINTS[:, 2], y=POINTS[:, 1], x=POINTS[:, 0], t=np.zeros((2, 2))),
}  # fmt: skip


@pytest.mark.parametrize("kind", KINDS)
def test_a_cloud_of_another_program_is_read(tmp_path: Path, kind: str) -> None:
    (tmp_path / "cloud").write_bytes(KINDS[kind])
    points = read_cloud(tmp_path / "cloud").points_mm
    if kind.startswith("stl"):  # in any order
        points = points[np.lexsort(points.T)]
    expected = POINTS[np.lexsort(POINTS.T)] if kind.startswith("stl") else POINTS
    np.testing.assert_allclose(points, expected, rtol=0, atol=2e-4)


@pytest.mark.parametrize(
    ("content", "said"),
    [
        (b"version https://git-lfs.github.com/spec/v1\noid sha256:0\nsize 1\n", "git lfs pull"),
        (b"\x89MCAP0\r\n", "crenel reconstruct"),
        (b"\x1f\x8b\x08\0\0", r"packed \(gzip\)\. Unpack"),
        (b"PK\3\4" + bytes(40), r"packed \(ZIP\)"),
        (b"<!DOCTYPE html><html></html>\n", "HTML"),
        (b"ISO-10303-21;\nHEADER;\n", "STEP"),
        (b"# vtk DataFile Version 3.0\na\nASCII\n1 2 3\n", "VTK"),
        (b"1 a 3 4 5\n1 a 3 4 5\n", "a row is 1, a, 3, 4, 5"),
        (PTS.rsplit("\n", 3)[0].encode(), f"of {COUNT} points: the file is incomplete"),
        (KINDS["ptx"][:-100], "incomplete"),
        (KINDS["lists before"][:-60], "incomplete"),
        (KINDS["lists in text"].replace(b"2 8 9", b"2 8 x", 1).replace(b"2 8 9", b"20 8 9", 1),
         "a row is not complete"),
        (KINDS["npy"][:-9], "NPY"),
        (saved(np.zeros((200, 300))), r"arrays are \(200, 300\)"),
        (saved(a=POINTS, b=POINTS), r"a \(60, 3\), b \(60, 3\)"),
        (saved(np.array([{}, 1], dtype=object)), "NPY"),
        (b"OFF\nmany\n", "header"),
        (b"v 1 2 3\nv 1 x 3\n", "x"),
        (ply(LE, [VERTEX, *AXES, "property list char int i"],
             with_lists("<", "p")[:12] + b"\xff" + bytes(2000)), "length below zero"),
    ],
)  # fmt: skip
def test_what_is_not_read_is_refused_for_its_reason(
    tmp_path: Path, content: bytes, said: str
) -> None:
    (tmp_path / "cloud").write_bytes(content)
    with pytest.raises(OperationError, match=said) as refused:
        read_cloud(tmp_path / "cloud")
    assert str(tmp_path / "cloud") in str(refused.value.what)
