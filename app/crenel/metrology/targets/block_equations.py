"""The linear equations of a block's readings and touches, and their solution."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from crenel.metrology.targets.block_readings import TIP, BlockReading, reading_rows
from crenel.metrology.targets.block_touches import BlockTouches, TouchRows, touch_rows
from crenel.metrology.transforms import Floats

Mask = NDArray[np.bool_]
CHANCE = 0.05
"""Readings that scatter by more in this share of all cases scatter as they state."""
LEAST_TOOL_MM = 1e-6
FACTOR_ROUNDS = 4


@dataclass(frozen=True, eq=False)
class BlockEquations:
    """Whitened rows: readings, touches, then what is stated of tools, tips and
    shared errors.

    ``table`` (R, U) with the columns: coordinates beside the drawing, zero errors and tips
    (``tools``), a rotation (3,) in mm at the lever of ``touch_rows``, shared errors of touches.
    """

    table: Floats
    off: Floats
    readings: int
    touches: int
    tool_rows: int
    """Rows of the readings' tools, which follow those of the touches."""
    tools: tuple[str, ...]
    sds_mm: Floats
    """(M + N,) by which readings and touches were divided."""

    @property
    def measured(self) -> int:
        return self.readings + self.touches

    @property
    def given(self) -> int:
        return len(self.table) - self.measured

    def rows_of(self, kept: Mask) -> Mask:
        """(R,) the rows without the readings and touches that are left out."""
        return np.append(kept, np.ones(self.given, np.bool_))

    def groups(self, kept: Mask) -> tuple[Mask, Mask]:
        """The rows by which the readings' scatter is judged, and those by which the touches'."""
        number, used = np.arange(len(self.table)), self.rows_of(kept)
        of_tools = (number >= self.measured) & (number < self.measured + self.tool_rows)
        of_touches = (number >= self.readings) & (number < self.measured)
        return used & ((number < self.readings) | of_tools), used & of_touches


@dataclass(frozen=True, eq=False)
class BlockSolution:
    """Values (U,) with their covariance, residuals (R,) whitened as stated, and by how much the
    variance of readings and of touches exceeds what they state."""

    values: Floats
    covariance: Floats
    left: Floats
    reading_factor: float
    touch_factor: float


def assemble(
    drawn_mm: Floats,
    readings: Sequence[BlockReading],
    touches: BlockTouches | None,
    T_obj_machine: Floats,
) -> BlockEquations:
    """The equations about the drawing (B,) and about where the block stands (4, 4)."""
    count, edges = len(drawn_mm), len(drawn_mm) - 5
    own = [] if touches is None else [one.name for one in touches.tips if one.sd_mm > 0]
    tools = tuple(dict.fromkeys([*(one.tool for one in readings if one.tool), *own]))
    rows = reading_rows(readings, edges, tools)
    sds = np.array([one.sd_mm for one in readings])
    distances = np.array([one.distance_mm for one in readings])
    off = distances - rows[:, :count] @ drawn_mm
    known = {one.tool: one.common_sd_mm for one in readings if one.tool and one.tool != TIP}
    of_tools = _prior_rows(known, tools, count)
    if touches is None or not len(touches):
        table = np.vstack([rows / sds[:, None], of_tools])
        whitened = np.append(off / sds, np.zeros(len(known)))
        return BlockEquations(table, whitened, len(readings), 0, len(known), tools, sds)
    taken = touch_rows(touches, T_obj_machine, drawn_mm)
    shared = taken.by_shared.shape[1]
    of_tips = _prior_rows(
        {one.name: one.sd_mm for one in touches.tips if one.sd_mm > 0 and not one.is_unknown},
        tools,
        count,
    )
    wide = np.zeros((len(rows) + len(of_tools) + len(of_tips), 3 + shared))
    narrow = np.vstack([rows / sds[:, None], of_tools, of_tips])
    others = np.hstack([narrow, wide])
    prior = np.hstack([np.zeros((shared, count + len(tools) + 3)), np.eye(shared)])
    own_rows = _touch_table(taken, touches, tools)
    table = np.vstack([others[: len(rows)], own_rows, others[len(rows) :], prior])
    zeros = np.zeros(len(of_tools) + len(of_tips) + shared)
    whitened = np.concatenate([off / sds, taken.off, zeros])
    every_sd = np.append(sds, taken.sds_mm)
    return BlockEquations(table, whitened, len(readings), len(touches), len(known), tools, every_sd)


def _prior_rows(sds_mm: dict[str, float], tools: Sequence[str], count: int) -> Floats:
    """A row for each tool whose error is known to a standard deviation."""
    rows = np.zeros((len(sds_mm), count + len(tools)))
    for i, (tool, sd_mm) in enumerate(sds_mm.items()):
        rows[i, count + tools.index(tool)] = 1 / max(sd_mm, LEAST_TOOL_MM)
    return rows


def _touch_table(taken: TouchRows, touches: BlockTouches, tools: Sequence[str]) -> Floats:
    by_tools = np.zeros((len(touches), len(tools)))
    for i, one in enumerate(touches.tips):
        if one.sd_mm > 0:
            by_tools[:, tools.index(one.name)] += taken.by_tips[:, i]
    return np.hstack([taken.by_coordinates, by_tools, taken.by_rotation, taken.by_shared])


def residuals_at_best(equations: BlockEquations, kept: Mask) -> tuple[Floats, Floats]:
    """Derivatives (R, U) and residuals (R,) of all rows, at the best fit to some (M + N,)."""
    table, off, rows = equations.table, equations.off, equations.rows_of(kept)
    solution = np.linalg.lstsq(table[rows], off[rows], rcond=None)[0]
    return table, table @ solution - off


def solve_block(equations: BlockEquations, kept: Mask) -> BlockSolution:
    """The best fit to the readings and touches that are kept (M + N,).

    Where they scatter by more than they state, and than chance does, they count for so much less.

    Source:
        Gauss-Markov; variance components after Foerstner.
    """
    table, off, used = equations.table, equations.off, equations.rows_of(kept)
    groups = {i: rows for i, rows in enumerate(equations.groups(kept)) if rows.any()}
    factors = np.ones(2)
    for _ in range(FACTOR_ROUNDS):
        weights = used.astype(np.float64)
        for i, rows in groups.items():
            weights[rows] /= factors[i]
        information = table.T @ (weights[:, None] * table)
        covariance = np.asarray(np.linalg.pinv(information, hermitian=True), np.float64)
        values: Floats = covariance @ (table.T @ (weights * off))
        left: Floats = off - table @ values
        determined = 1 - weights * np.einsum("ri,ij,rj->r", table, covariance, table)
        grown = [
            _variance_factor(float(weights[rows] @ left[rows] ** 2), float(determined[rows].sum()))
            for rows in groups.values()
        ]
        if max(grown, default=1.0) == 1.0:
            break
        factors[list(groups)] *= grown
    return BlockSolution(values, covariance, left, float(factors[0]), float(factors[1]))


def _variance_factor(squares: float, freedom: float) -> float:
    """By how much a variance exceeds what is stated, if by more than chance does."""
    from scipy.special import chdtri  # slow to import, and seldom needed

    if freedom < 0.5 or squares <= float(chdtri(freedom, CHANCE)):
        return 1.0
    return squares / freedom
