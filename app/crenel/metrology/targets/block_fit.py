"""A block's faces from readings of their distances and from touches, by least squares."""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import partial
from itertools import combinations

import numpy as np

from crenel.metrology.fitting.outlier_search import Agreement, find_agreement
from crenel.metrology.targets.block_equations import (
    BlockEquations,
    BlockSolution,
    Mask,
    assemble,
    residuals_at_best,
    solve_block,
)
from crenel.metrology.targets.block_placement import BlockPlacement
from crenel.metrology.targets.block_readings import TIP, BlockReading, centre_axes, face_axis
from crenel.metrology.targets.block_touches import BlockTouches, FaceForm, face_forms, turn_block
from crenel.metrology.transforms import Floats, apply

EXPLAINED = 0.05
"""The chi-square of an exchange of two readings falls to this share of what it was."""
LIKELY_SDS = 5.0
"""A touch belongs to a face whose distance is within so many standard deviations."""
EXCHANGE_SLACK_MM = 0.05
"""And this, for what a wrong touch did to the others."""
ROUNDS = 3
"""The touches are made linear again about the block as found; its drawing begins so near."""


@dataclass(frozen=True, eq=False)
class TouchFit:
    """How N touches agree with the block.

    ``T_obj_machine`` (4, 4); ``residuals_mm`` (N,) along the axis of each face, ``kept`` and
    ``doubtful`` (N,) as of ``BlockFit``. ``exchanged`` are two touches that agree if the names of
    their faces are exchanged. By ``variance_factor`` their variance exceeds what they state.
    """

    T_obj_machine: Floats
    residuals_mm: Floats
    kept: Mask
    doubtful: Mask
    exchanged: tuple[int, int] | None
    variance_factor: float
    forms: tuple[FaceForm, ...]


@dataclass(frozen=True, eq=False)
class BlockFit:
    """A block by its readings and touches.

    ``coordinates_mm`` (B,) with their covariance (B, B), each axis about the mean of its own faces,
    and ``sds_mm`` (B,), with which the faces as independent ones have the uncertainty of their
    distances. ``residuals_mm`` (M,) are reading minus fit, also of the readings left out
    (``kept`` (M,)); of ``doubtful`` (M,) one contradicts the others and nothing tells which.
    ``exchanged`` are two readings that agree if their values are exchanged. ``tools`` are the zero
    errors and tip diameters found, with their standard uncertainties.
    """

    coordinates_mm: Floats
    covariance_mm2: Floats
    sds_mm: Floats
    residuals_mm: Floats
    kept: Mask
    doubtful: Mask
    exchanged: tuple[int, int] | None
    tools: dict[str, tuple[float, float]]
    variance_factor: float
    touched: TouchFit | None


def shows_tip(
    drawn_mm: Floats, readings: Sequence[BlockReading], touches: BlockTouches | None = None
) -> bool:
    """Whether the diameter of a tip of unknown size, if there is one, follows from the rest.

    Touches alone never show it: all faces may lie further out while the tip is smaller.
    """
    equations = assemble(drawn_mm, readings, touches, np.eye(4))
    if TIP not in equations.tools:
        return True
    column = len(drawn_mm) + equations.tools.index(TIP)
    own, others = equations.table[:, column], np.delete(equations.table, column, axis=1)
    rest = own - others @ np.linalg.lstsq(others, own, rcond=None)[0]
    return float(rest @ rest) > 1e-6 * float(own @ own)


def fit_block(
    drawn_mm: Floats,
    readings: Sequence[BlockReading],
    touches: BlockTouches | None = None,
    placement: BlockPlacement | None = None,
) -> BlockFit:
    """The faces that agree best with all readings and touches that agree with each other.

    Those that contradict are sought among all ones and twos (``find_agreement``); of two, it is
    tried whether they were exchanged. If readings, or touches, scatter by more than they state, and
    by more than chance does, their uncertainties grow in proportion. Errors that touches share stay
    as stated.

    Args:
        drawn_mm: (B,) coordinates of the drawing, about which the faces are sought.
        readings: M, which connect, with the touches, all faces of each axis (``open_faces``) and
            show the diameter of an unknown tip (``shows_tip``).
        touches: N, with the ``placement`` of the block.

    Returns:
        The block, about the mean of the faces of each axis.

    Source:
        Gauss-Markov with inner constraints; data snooping after Baarda, for ones and twos.
    """
    T = np.eye(4) if placement is None else placement.T_obj_machine
    for _ in range(1 if touches is None else ROUNDS):
        equations = assemble(drawn_mm, readings, touches, T)
        every = np.ones(equations.measured, np.bool_)
        solve = partial(residuals_at_best, equations)
        found = find_agreement(solve, every, every, given=equations.given)
        solved = solve_block(equations, found.kept)
        turn = len(drawn_mm) + len(equations.tools)
        T = T if touches is None else turn_block(T, solved.values[turn : turn + 3])
    count, own = equations.readings, slice(0, len(drawn_mm))
    centring = centre_axes(len(drawn_mm) - 5)
    # so that the faces, taken for independent, have the uncertainty of their distances
    growth = 1 / np.sqrt(np.diag(centring))
    about_mean = centring @ solved.covariance[own, own] @ centring.T
    agreeing = bool(found.kept[:count].all() and not found.doubtful[:count].any())
    left_mm = solved.left[: equations.measured] * equations.sds_mm
    tools = _tools(equations, solved, touches, len(drawn_mm))
    touched = None
    if touches is not None:
        touched = _touch_fit(drawn_mm, touches, T, equations, solved, found, tools)
    return BlockFit(
        centring @ (drawn_mm + solved.values[own]),
        about_mean,
        growth * np.sqrt(np.maximum(np.diag(about_mean), 0.0)),
        left_mm[:count],
        found.kept[:count],
        found.doubtful[:count],
        None if agreeing else _find_exchange(readings, equations),
        tools,
        solved.reading_factor,
        touched,
    )


def _tools(
    equations: BlockEquations, solved: BlockSolution, touches: BlockTouches | None, first: int
) -> dict[str, tuple[float, float]]:
    """Zero errors and diameters with their standard uncertainties."""
    tips = () if touches is None else touches.tips
    stated_mm = {one.name: one.diameter_mm for one in tips if not one.is_unknown}
    sds = np.sqrt(np.maximum(np.diag(solved.covariance), 0.0))
    return {
        tool: (stated_mm.get(tool, 0.0) + float(solved.values[i]), float(sds[i]))
        for i, tool in enumerate(equations.tools, first)
    }


def _touch_fit(
    drawn_mm: Floats,
    touches: BlockTouches,
    T_obj_machine: Floats,
    equations: BlockEquations,
    solved: BlockSolution,
    found: Agreement,
    tools: dict[str, tuple[float, float]],
) -> TouchFit:
    own = slice(equations.readings, equations.measured)
    kept, doubtful = found.kept[own], found.doubtful[own]
    faces_mm = drawn_mm + solved.values[: len(drawn_mm)]
    sds_mm = equations.sds_mm[own] * solved.touch_factor**0.5
    wrong = [int(i) for i in np.flatnonzero(~kept | doubtful)]
    at = apply(T_obj_machine, touches.points_mm)
    diameters_mm = [tools[one.name][0] if one.sd_mm else one.diameter_mm for one in touches.tips]
    radii_mm = np.array(diameters_mm)[touches.tip] / 2

    def fits(i: int, j: int) -> bool:
        """Whether touch i lies on the face of touch j."""
        face, side = int(touches.faces[j]), touches.away[j]
        axis = face_axis(face, len(drawn_mm) - 5)
        beside = at[i, axis] - side * radii_mm[i] - faces_mm[face]
        return abs(float(beside)) < LIKELY_SDS * float(sds_mm[i]) + EXCHANGE_SLACK_MM

    pairs = [
        (i, j)
        for i, j in combinations(wrong, 2)
        if touches.faces[i] != touches.faces[j] and fits(i, j) and fits(j, i)
    ]
    return TouchFit(
        T_obj_machine,
        solved.left[own] * equations.sds_mm[own],
        kept,
        doubtful,
        pairs[0] if len(pairs) == 1 else None,
        solved.touch_factor,
        face_forms(touches, T_obj_machine, kept, len(drawn_mm) - 5),
    )


def _find_exchange(
    readings: Sequence[BlockReading], equations: BlockEquations
) -> tuple[int, int] | None:
    """Two readings whose exchange makes all readings agree, which no other mistake does by
    chance."""
    table, off = equations.table, equations.off
    basis = np.linalg.svd(table, full_matrices=False)
    U = basis[0][:, basis[1] > 1e-9 * basis[1].max()]
    left = off - U @ (U.T @ off)
    before = float(left @ left)
    best: tuple[float, tuple[int, int]] | None = None
    for i, j in combinations(range(len(readings)), 2):
        swapped = off.copy()
        apart = readings[j].distance_mm - readings[i].distance_mm
        swapped[i] += apart / readings[i].sd_mm
        swapped[j] -= apart / readings[j].sd_mm
        rest = swapped - U @ (U.T @ swapped)
        square = float(rest @ rest)
        if best is None or square < best[0]:
            best = square, (i, j)
    if best is None or best[0] > EXPLAINED * before:
        return None
    freedom = max(len(off) - U.shape[1], 1)
    return best[1] if best[0] < 9 * freedom else None
