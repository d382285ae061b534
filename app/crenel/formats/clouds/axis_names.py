"""Which columns of a table are x, y and z, by the names that programs give them."""

import re
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from crenel.errors import OperationError
from crenel.formats.clouds.points import Cloud, cloud_from_columns, scale_cloud
from crenel.formats.clouds.rows import format_error
from crenel.formats.file_names import display_path
from crenel.messages.message import message
from crenel.metrology.transforms import Floats
from crenel.units import MM_PER

UNITS_MM = {
    **dict.fromkeys(("mm", "millimeter", "millimetre", "millimeters", "millimetres"), MM_PER["mm"]),
    **dict.fromkeys(("m", "meter", "metre", "meters", "metres"), MM_PER["m"]),
    **dict.fromkeys(("cm", "centimeter", "centimetre"), MM_PER["cm"]),
    **dict.fromkeys(("um", "µm", "μm", "micron", "microns"), MM_PER["µm"]),
    **dict.fromkeys(("in", "inch", "inches"), MM_PER["inch"]),
}
FILLERS = frozenset(
    {
        "measured",
        "meas",
        "gemessen",
        "actual",
        "axis",
        "cartesian",
        "coord",
        "coordinate",
        "coordinates",
        "coords",
        "p",
        "point",
    }
    | {"points", "pos", "position", "positions", "pt", "value", "xyz"}
    | {"ist", "koordinate", "koordinaten", "messwert", "punkt", "punkte", "wert"}
)
"""Words beside the axis that say nothing of it."""
TOKEN = re.compile(r"[A-ZÄÖÜ]?[a-zäöüµμ]+|[A-ZÄÖÜ]+(?![a-zäöü])|\d+")
JOINED = re.compile(rf"(?:p|pos|pt|point|coord)?([xyz])({'|'.join(UNITS_MM)})?")
"""Axis and unit without anything between."""
NUMBERED = {"0": "x", "1": "y", "2": "z"}


@dataclass(frozen=True)
class Axes:
    """Where a table has x, y and z."""

    places: tuple[int, int, int]
    mm_per_unit: float | None = None
    """The unit of the coordinates, if the names of the columns state one."""


def find_axes(names: Sequence[str]) -> Axes | None:
    """The columns of x, y and z by their names; None if they are not there or not clear.

    Example:
        >>> find_axes(["No.", "X [mm]", "Y [mm]", "Z [mm]"])
        Axes(places=(1, 2, 3), mm_per_unit=1.0)
        >>> find_axes(["Intensity", "Points:0", "Points:1", "Points:2"])
        Axes(places=(1, 2, 3), mm_per_unit=None)
    """
    plain = [name.strip(" \"'").lower() for name in names]
    if all(plain.count(axis) == 1 for axis in "xyz"):
        return Axes((plain.index("x"), plain.index("y"), plain.index("z")))
    read = [_read_name(name) for name in names]
    axes = [None if one is None else one[0] for one in read]
    if any(axes.count(axis) != 1 for axis in "xyz"):
        return None
    x, y, z = (axes.index(axis) for axis in "xyz")
    units = {one[1] for one in read if one is not None}
    return Axes((x, y, z), units.pop()) if len(units) == 1 else None


def choose_axes(path: Path, names: Sequence[str], wanted: Sequence[str]) -> Axes:
    """The columns that the user names, or numbers from 1; raises ``OperationError``.

    Args:
        names: of all columns, empty for those without one.
        wanted: of x, y and z.
    """
    known = [name.strip(" \"'") for name in names]
    places = []
    for one in wanted:
        if known.count(one) == 1:
            places.append(known.index(one))
        elif one.isdecimal() and 1 <= int(one) <= len(known):
            places.append(int(one) - 1)
        else:
            raise OperationError(
                "cloud-column-missing",
                message("cloud-no-such-column", path=display_path(path), name=one),
                message("cloud-columns-there", names=list_columns(names)),
                message("cloud-give-columns"),
            )
    x, y, z = places
    read = [_read_name(known[place]) for place in places]
    units = {one[1] for one in read if one is not None}
    if len(units) > 1:
        raise _unit_error(path, [known[place] for place in places])
    return Axes((x, y, z), units.pop() if units and None not in read else None)


def find_named_axes(path: Path, names: Sequence[str], columns: Sequence[str] | None) -> Axes:
    """The columns of x, y and z.

    Raises:
        OperationError: they are not there, under names that are known or that the user gives.
    """
    axes = find_axes(names) if columns is None else choose_axes(path, names, columns)
    if axes is not None:
        return axes
    missing = [axis for axis in "xyz" if axis not in (name.lower() for name in names)]
    if 0 < len(missing) < 3:
        raise format_error(path, message("cloud-points-have-no", axes=", ".join(missing)))
    raise unknown_columns_error(path, names)


def cloud_of_axes(columns: dict[str, Floats], names: Sequence[str], axes: Axes) -> Cloud:
    """The cloud of columns (N,) by name, with x, y and z where ``axes`` has them."""
    xyz = {axis: columns[names[place]] for axis, place in zip("xyz", axes.places, strict=True)}
    return scale_cloud(cloud_from_columns(columns | xyz), axes.mm_per_unit or 1.0)


def unknown_columns_error(path: Path, names: Sequence[str]) -> OperationError:
    """The columns of a table do not show which are x, y and z."""
    read = [(name, found) for name in names if (found := _read_name(name)) is not None]
    if sorted(axis for _, (axis, _) in read) == ["x", "y", "z"]:
        return _unit_error(path, [name for name, _ in read])
    return OperationError(
        "cloud-columns-unknown",
        display_path(path),
        message("cloud-columns-there", names=list_columns(names)),
        message("cloud-give-columns"),
    )


def _unit_error(path: Path, names: Sequence[str]) -> OperationError:
    return OperationError(
        "cloud-columns-unknown",
        display_path(path),
        message("cloud-columns-of-several-units", names=list_columns(names)),
        message("cloud-convert-to-one-unit"),
    )


def list_columns(names: Sequence[str]) -> str:
    """Names of columns for a message, numbered where they have none."""
    return ", ".join(name.strip(" \"'") or str(i) for i, name in enumerate(names, 1))


def unit_of_row(cells: Sequence[str]) -> float | None:
    """mm per unit if all cells of a row are one unit."""
    units = {UNITS_MM.get(cell.strip(" \"'[]()").lower()) for cell in cells if cell.strip()}
    return units.pop() if len(units) == 1 else None


def _read_name(name: str) -> tuple[str, float | None] | None:
    """Axis and mm per unit of a column; None if it is no coordinate."""
    tokens = [token.lower() for token in TOKEN.findall(name)]
    axes: list[str] = []
    unit: float | None = None
    for token in tokens:
        if (joined := JOINED.fullmatch(token)) is not None:
            axes.append(joined[1])
            unit = UNITS_MM.get(joined[2] or "", unit)
        elif token in UNITS_MM:
            unit = UNITS_MM[token]
        elif token in NUMBERED and tokens[0] in FILLERS:
            axes.append(NUMBERED[token])
        elif token not in FILLERS:
            return None
    return (axes[0], unit) if len(axes) == 1 else None
