"""Files that are given for clouds and are none that can be read, by their first bytes."""

import re
from pathlib import Path

from crenel.errors import OperationError
from crenel.formats.file_names import display_path
from crenel.messages.message import message

OTHERS: tuple[tuple[bytes, str], ...] = (
    (rb"\s*ISO-10303", "STEP"),
    (rb"(.{72}S +1\s)", "IGES"),
    (rb"glTF", "glTF"),
    (rb"# vtk|<VTKFile|<\?xml[^>]*>\s*<VTKFile", "VTK"),
    (rb"\s*<(!doctype )?html", "HTML"),
    (rb"\s*<\?xml|\s*<[A-Za-z]+[ >]", "XML"),
    (rb"\s*[{\[]\s*[\"{\[\]}]", "JSON"),
    (rb"%PDF", "PDF"),
    (rb"\x89PNG", "PNG"),
    (rb"\xff\xd8\xff", "JPEG"),
    (rb"II\*\x00|MM\x00\*", "TIFF"),
    (rb"\x89HDF", "HDF5"),
    (rb"MATLAB 5", "MATLAB"),
    (rb"#ROSBAG", "ROS bag"),
    (rb"SQLite format 3", "SQLite"),
    (rb"Kaydara FBX", "FBX"),
)
PACKED = (
    (rb"\x1f\x8b", "gzip"),
    (rb"PK\x03\x04", "ZIP"),
    (rb"7z\xbc\xaf", "7z"),
    (rb"BZh", "bzip2"),
)
MCAP = b"\x89MCAP0"
LFS = b"version https://git-lfs"


def refuse_other_files(path: Path, head: bytes) -> None:
    """Raises ``OperationError`` for a file of another kind that is known."""
    if head.startswith(LFS):
        why, remedy = message("cloud-is-lfs-pointer"), message("cloud-fetch-from-lfs")
    elif head.startswith(MCAP):
        why, remedy = message("cloud-is-recording-not-cloud"), message("cloud-reconstruct-first")
    elif kind := _kind(PACKED, head):
        why, remedy = message("cloud-is-packed", format=kind), message("cloud-unpack-first")
    elif kind := _kind(OTHERS, head):
        why, remedy = message("cloud-of-format", format=kind), message("cloud-give-known-format")
    else:
        return
    raise OperationError("cloud-unreadable", display_path(path), why, remedy)


def _kind(kinds: tuple[tuple[bytes, str], ...], head: bytes) -> str:
    return next((name for mark, name in kinds if re.match(mark, head, re.IGNORECASE)), "")
