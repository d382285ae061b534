"""A block's edges from readings of its widths, steps and heights, by least squares.

Every reading is the distance of two parallel faces. A calliper's zero error and the diameter of an
arm's tip act alike: they lengthen what is measured from outside (a merlon), shorten what is
measured from inside (a groove), and cancel out where both faces look the same way (a step). All
faces that look one way may so be further out while the tip is smaller: no reading of the tip alone
shows its diameter, one outside or inside reading of another tool does.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import combinations

import numpy as np
from numpy.typing import NDArray

from app.metrology.fitting.outlier_search import find_agreement
from app.metrology.transforms import Floats

FACE_NAMES = ("front", "back", "crest", "floor", "base")
TIP = "tip"
"""The tool whose readings are distances of tip centres: its diameter is unknown."""
# Readings that scatter by more in this share of all cases scatter as they state.
CHANCE = 0.05
# The chi-square of an exchange of two readings falls to this share of what it was.
EXPLAINED = 0.05


@dataclass(frozen=True)
class BlockReading:
    """The distance from one face to another, which lies further along the axis.

    ``first`` and ``second`` are indices among the coordinates of a block: its edges, then
    ``FACE_NAMES``. ``sd_mm`` is of this reading alone, ``common_sd_mm`` of the zero error of its
    ``tool``, which all readings of the tool share.
    """

    first: int
    second: int
    distance_mm: float
    sd_mm: float
    tool: str = ""
    common_sd_mm: float = 0.0


@dataclass(frozen=True)
class ReadingFit:
    """A block by its readings.

    ``coordinates_mm`` (B,) with their covariance (B, B), each axis about the mean of its own faces,
    and ``sds_mm`` (B,), with which the faces as independent ones have the uncertainty of their
    distances. ``residuals_mm`` (N,) are reading minus fit, also of the readings left out
    (``kept`` (N,)); of ``doubtful`` (N,) one contradicts the others and nothing tells which.
    ``exchanged`` are two readings that agree if their values are exchanged. ``tools`` are the zero
    errors and tip diameters found, with their standard uncertainties.
    """

    coordinates_mm: Floats
    covariance_mm2: Floats
    sds_mm: Floats
    residuals_mm: Floats
    kept: NDArray[np.bool_]
    doubtful: NDArray[np.bool_]
    exchanged: tuple[int, int] | None
    tools: dict[str, tuple[float, float]]
    variance_factor: float


def face_axis(face: int, edge_count: int) -> int:
    """Along which axis a face is measured: 0, 1 or 2."""
    return 0 if face < edge_count else 1 if face < edge_count + 2 else 2


def outward(face: int, edge_count: int) -> int:
    """Which way along its axis a face looks: 1 or -1."""
    if face < edge_count:
        return 1 if face % 2 else -1
    return {"front": -1, "back": 1, "crest": 1, "floor": 1, "base": -1}[
        FACE_NAMES[face - edge_count]
    ]


def tool_sense(first: int, second: int, edge_count: int) -> int:
    """By how many times a zero error or a tip's diameter is in a reading: 1, -1 or 0."""
    return (outward(second, edge_count) - outward(first, edge_count)) // 2


def open_faces(readings: Sequence[BlockReading], edge_count: int) -> list[int]:
    """Faces that no chain of readings connects with the first one of their axis."""
    group = list(range(edge_count + 5))
    for one in readings:
        a, b = group[one.first], group[one.second]
        group = [a if own == b else own for own in group]
    first = {0: 0, 1: edge_count, 2: edge_count + 2}
    return [
        face for face, own in enumerate(group) if own != group[first[face_axis(face, edge_count)]]
    ]


def free_tools(readings: Sequence[BlockReading], edge_count: int) -> list[str]:
    """Tools of unknown diameter that no other tool's reading shows."""
    rows, tools = _design(readings, edge_count)
    columns = enumerate(tools, edge_count + 5)
    given = np.zeros((0, rows.shape[1]))
    for column, tool in enumerate(tools, edge_count + 5):
        if tool != TIP:
            given = np.vstack([given, np.eye(rows.shape[1])[column]])
    table = np.vstack([rows, given])
    return [tool for column, tool in columns if tool == TIP and not _determines(table, column)]


def _determines(rows: Floats, column: int) -> bool:
    others = np.delete(rows, column, axis=1)
    rest = rows[:, column] - others @ np.linalg.lstsq(others, rows[:, column], rcond=None)[0]
    return float(rest @ rest) > 1e-6


def _design(readings: Sequence[BlockReading], edge_count: int) -> tuple[Floats, list[str]]:
    """Derivatives (N, B + T) of the readings by coordinates and tools, and the tools."""
    tools = [name for name in dict.fromkeys(one.tool for one in readings) if name]
    rows = np.zeros((len(readings), edge_count + 5 + len(tools)))
    for i, one in enumerate(readings):
        rows[i, one.second], rows[i, one.first] = 1.0, -1.0
        if one.tool:
            sense = tool_sense(one.first, one.second, edge_count)
            rows[i, edge_count + 5 + tools.index(one.tool)] = sense
    return rows, tools


def fit_readings(readings: Sequence[BlockReading], edge_count: int) -> ReadingFit:
    """The faces that agree best with all readings that agree with each other.

    Readings that contradict are sought among all ones and twos (``find_agreement``); of two, it is
    tried whether they were exchanged. If the readings scatter by more than they state, the
    uncertainties grow in proportion.

    Args:
        readings: N, which connect all faces of each axis (``open_faces``) and show the diameter of
            a tip (``free_tools``).
        edge_count: number of edges along X.

    Returns:
        The block, about the mean of the faces of each axis.

    Source:
        Gauss-Markov with inner constraints; data snooping after Baarda, for ones and twos.
    """
    J, given, tools = _whiten(readings, edge_count)
    values = np.array([one.distance_mm for one in readings])
    sds = np.array([one.sd_mm for one in readings])
    table = np.vstack([J, given])
    count = len(readings)

    def equations(kept: NDArray[np.bool_]) -> tuple[Floats, Floats]:
        rows = np.append(kept, np.ones(len(given), np.bool_))
        off = np.append(values / sds, np.zeros(len(given)))
        solution = np.linalg.lstsq(table[rows], off[rows], rcond=None)[0]
        return table, table @ solution - off

    every = np.ones(count, np.bool_)
    found = find_agreement(equations, every, every, given=len(given))
    agreeing = bool(found.kept.all() and not found.doubtful.any())
    rows = np.append(found.kept, np.ones(len(given), np.bool_))
    off = np.append(values / sds, np.zeros(len(given)))
    information = table[rows].T @ table[rows]
    covariance = np.linalg.pinv(information, hermitian=True)
    solution = covariance @ (table[rows].T @ off[rows])
    left = off - table @ solution
    freedom = int(rows.sum()) - np.linalg.matrix_rank(information, hermitian=True)
    factor = _variance_factor(float(left[rows] @ left[rows]), freedom)
    centring, growth = _centring(edge_count)
    own = slice(0, edge_count + 5)
    about_mean = factor * centring @ covariance[own, own] @ centring.T
    sds_of_tools = np.sqrt(factor * np.diag(covariance)[edge_count + 5 :])
    return ReadingFit(
        centring @ solution[own],
        about_mean,
        growth * np.sqrt(np.maximum(np.diag(about_mean), 0.0)),
        left[:count] * sds,
        found.kept,
        found.doubtful,
        None if agreeing else _find_exchange(readings, table, off),
        {
            tool: (float(solution[edge_count + 5 + i]), float(sds_of_tools[i]))
            for i, tool in enumerate(tools)
        },
        factor,
    )


def _variance_factor(squares: float, freedom: int) -> float:
    """By how much the readings' variance exceeds what they state, if by more than chance does."""
    from scipy.special import chdtri  # slow to import, and seldom needed

    if freedom < 1 or squares <= float(chdtri(freedom, CHANCE)):
        return 1.0
    return squares / freedom


def _whiten(readings: Sequence[BlockReading], edge_count: int) -> tuple[Floats, Floats, list[str]]:
    """Rows (N, U) over the readings' standard deviations, those of the tools' zero errors, and the
    tools."""
    rows, tools = _design(readings, edge_count)
    sds = np.array([one.sd_mm for one in readings])
    known = {one.tool: one.common_sd_mm for one in readings if one.tool and one.tool != TIP}
    given = np.zeros((len(known), rows.shape[1]))
    for i, (tool, sd_mm) in enumerate(known.items()):
        given[i, edge_count + 5 + tools.index(tool)] = 1 / max(sd_mm, 1e-6)
    return rows / sds[:, None], given, tools


def _centring(edge_count: int) -> tuple[Floats, Floats]:
    """(B, B) subtracts the mean of each axis; (B,) factors by which standard deviations about the
    mean grow so that the faces, taken for independent, have the uncertainty of their distances."""
    axes = np.array([face_axis(face, edge_count) for face in range(edge_count + 5)])
    same = axes[:, None] == axes
    size = same.sum(axis=1)
    return np.eye(len(axes)) - same / size, np.sqrt(size / (size - 1))


def _find_exchange(
    readings: Sequence[BlockReading],
    table: Floats,
    off: Floats,
) -> tuple[int, int] | None:
    """Two readings whose exchange makes all readings agree, which no other mistake does by
    chance."""
    basis = np.linalg.svd(table, full_matrices=False)
    U = basis[0][:, basis[1] > 1e-9 * basis[1].max()]
    left = off - U @ (U.T @ off)
    before = float(left @ left)
    best: tuple[float, tuple[int, int]] | None = None
    for i, j in combinations(range(len(readings)), 2):
        swapped = off.copy()
        swapped[i] = readings[j].distance_mm / readings[i].sd_mm
        swapped[j] = readings[i].distance_mm / readings[j].sd_mm
        rest = swapped - U @ (U.T @ swapped)
        square = float(rest @ rest)
        if best is None or square < best[0]:
            best = square, (i, j)
    if best is None or best[0] > EXPLAINED * before:
        return None
    freedom = max(len(off) - U.shape[1], 1)
    return best[1] if best[0] < 9 * freedom else None
