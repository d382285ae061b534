"""Where a touched block stands, by its drawing, and which touches are named for another face."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from crenel.metrology.robust import median, sigma_from_median
from crenel.metrology.targets.block_readings import face_axis, outward
from crenel.metrology.targets.block_touches import BlockTouches
from crenel.metrology.transforms import Floats, apply, nearest_rotation, rigid, rotation_from_vector

DRAWS = 400
LEAST_CUT_MM = 0.4
"""Touches so near to the drawing always count: a block is made within less."""
BESIDE_MM = 1.0
"""A touch that is further beside its face as drawn was taken of another one."""
NEAR_MM = 0.5
"""And within this, of this one."""
MOST_OF_FACE = 0.75
"""Share of a face's touches by which the face itself counts as named wrongly."""
ROUNDS = 4


@dataclass(frozen=True, eq=False)
class BlockPlacement:
    """The block in the frame of its touches.

    ``T_obj_machine`` (4, 4); ``beside_mm`` (N,) is how far each touch is beside its face as drawn,
    along its axis; ``radii_mm`` (N,) from the face to the touch, the unknown tip's by the drawing.
    ``scale`` is by how much the drawing is larger than the touches: 1 unless they are in another
    unit. ``mirrored``: no rotation brings the axes of the machine onto those of the block.
    """

    T_obj_machine: Floats
    beside_mm: Floats
    radii_mm: Floats
    scale: float
    mirrored: bool


@dataclass(frozen=True)
class Mislabelled:
    """Touches that lie beside their face as drawn.

    ``touches`` of which two were exchanged if ``exchanged``, and else the first that is wrong, with
    the ``face`` on which it lies, if any; ``faces`` of which all touches were exchanged.
    """

    touches: tuple[int, ...] = ()
    exchanged: bool = False
    face: int | None = None
    faces: tuple[int, int] | None = None


def place_touches(touches: BlockTouches, drawn_mm: Floats) -> BlockPlacement:
    """Where the block stands, by most of its touches; the names of a few may be wrong.

    The axes of the block are found one by one: along each, the coordinates of the touched faces are
    a linear function of the touches. Least median of squares chooses it (Rousseeuw, 1984).

    Args:
        touches: on at least two faces each of two axes, which ``fixes_block`` tells.
        drawn_mm: (B,) coordinates that the drawing has.
    """
    edges = len(drawn_mm) - 5
    axes = touches.axes(edges)
    radii = touches.radii_mm()
    middle = touches.points_mm.mean(axis=0)
    rows, scales = np.zeros((3, 3)), []
    for axis in range(3):
        own = axes == axis
        if not _has_two_faces(touches, own):
            continue
        free_tip = axis == 0 and _shows_tip(touches, own)
        direction, radius = _axis_direction(
            touches.points_mm[own] - middle,
            drawn_mm[touches.faces[own]] + touches.away[own] * radii[own],
            -touches.away[own] * _unknown(touches)[own] if free_tip else None,
        )
        rows[axis] = direction
        scales.append(float(np.linalg.norm(direction)))
        if free_tip:
            radii = radii + radius * _unknown(touches)
    R = _best_rotation(rows, touches, radii, drawn_mm)
    mirrored = len(scales) == 3 and bool(np.linalg.det(rows) < 0)
    T = _place(R, touches, radii, drawn_mm)
    for _ in range(ROUNDS):
        T, radii = _refine(T, touches, radii, drawn_mm)
    return BlockPlacement(T, _beside_mm(T, touches, radii, drawn_mm), radii, scales[0], mirrored)


def fixes_block(touches: BlockTouches, edge_count: int) -> bool:
    """Whether the touches can show where the block stands: on two faces each of two axes."""
    axes = touches.axes(edge_count)
    return sum(_has_two_faces(touches, axes == axis) for axis in range(3)) >= 2


def find_mislabelled(
    placement: BlockPlacement, touches: BlockTouches, drawn_mm: Floats
) -> Mislabelled | None:
    """What is named wrongly among the touches; None if all lie near their faces as drawn."""
    wrong = np.flatnonzero(np.abs(placement.beside_mm) > BESIDE_MM)
    if not len(wrong):
        return None
    fits = _faces_of(wrong, placement, touches, drawn_mm)
    whole = [
        face
        for face in sorted({int(touches.faces[i]) for i in wrong})
        if np.mean(np.abs(placement.beside_mm[touches.faces == face]) > BESIDE_MM) > MOST_OF_FACE
    ]
    if len(whole) == 2:
        one, other = whole
        others = {one: other, other: one}
        if all(others.get(int(touches.faces[i])) in fits[int(i)] for i in wrong):
            return Mislabelled(faces=(one, other))
    if len(wrong) == 2:
        i, j = (int(k) for k in wrong)
        if touches.faces[j] in fits[i] and touches.faces[i] in fits[j]:
            return Mislabelled((i, j), exchanged=True)
    first = int(wrong[0])
    return Mislabelled((first,), face=fits[first][0] if len(fits[first]) == 1 else None)


def _faces_of(
    numbers: NDArray[np.intp], placement: BlockPlacement, touches: BlockTouches, drawn_mm: Floats
) -> dict[int, list[int]]:
    """The faces on which each of some touches may have been taken, by its coordinates."""
    edges = len(drawn_mm) - 5
    sides = {face: float(outward(face, edges)) for face in range(len(drawn_mm))}
    sides |= dict(zip(touches.faces.tolist(), touches.away.tolist(), strict=True))
    at = apply(placement.T_obj_machine, touches.points_mm)

    def lies_on(i: int, face: int, side: float) -> bool:
        along = at[i, face_axis(face, edges)] - side * placement.radii_mm[i]
        return abs(float(along - drawn_mm[face])) < NEAR_MM

    return {
        int(i): [face for face, side in sides.items() if lies_on(int(i), face, side)]
        for i in numbers
    }


def _unknown(touches: BlockTouches) -> Floats:
    """(N,) 1 for touches by a tip of unknown diameter."""
    return np.array([float(one.is_unknown) for one in touches.tips])[touches.tip]


def _has_two_faces(touches: BlockTouches, own: NDArray[np.bool_]) -> bool:
    return len(set(touches.faces[own].tolist())) >= 2


def _shows_tip(touches: BlockTouches, own: NDArray[np.bool_]) -> bool:
    """Whether the drawing shows a tip's diameter: by two faces and more that look either way."""
    if not _unknown(touches)[own].any():
        return False
    sides = [set(touches.faces[own & (touches.away == side)].tolist()) for side in (1, -1)]
    return min(map(len, sides)) >= 2


def _axis_direction(
    points_mm: Floats, values_mm: Floats, sides: Floats | None
) -> tuple[Floats, float]:
    """The linear function of points (N, 3) that has these values (N,), as far as most agree, and
    the radius whose ``sides`` (N,) it has beside."""
    table = np.column_stack([points_mm, np.ones(len(points_mm))])
    if sides is not None:
        table = np.column_stack([table, sides])
    size = table.shape[1]
    rng = np.random.default_rng(0)  # repeatable
    chosen = np.array([rng.permutation(len(table))[:size] for _ in range(DRAWS)])
    some = np.einsum("bij,bj->bi", np.linalg.pinv(table[chosen], rcond=1e-6), values_mm[chosen])
    misfits = np.median(np.abs(some @ table.T - values_mm), axis=1)
    solution = some[int(np.argmin(misfits))]
    for _ in range(ROUNDS):
        off = np.abs(table @ solution - values_mm)
        near = off <= max(3 * sigma_from_median(off), LEAST_CUT_MM)
        solution = np.linalg.lstsq(table[near], values_mm[near], rcond=None)[0]
    return solution[:3], float(solution[4]) if sides is not None else 0.0


def _best_rotation(
    rows: Floats, touches: BlockTouches, radii_mm: Floats, drawn_mm: Floats
) -> Floats:
    """The rotation (3, 3) to the block by its axes (3, 3) as found, each alone or by the others."""
    lengths = np.linalg.norm(rows, axis=1)
    unit = rows / np.where(lengths > 0, lengths, 1.0)[:, None]
    choices = []
    for given in ((0, 1, 2), (0, 1), (0, 2), (1, 2)):
        if not all(lengths[axis] > 0 for axis in given):
            continue
        axes = unit.copy()
        for axis in set(range(3)) - set(given):
            axes[axis] = np.cross(axes[(axis + 1) % 3], axes[(axis + 2) % 3])
        R = nearest_rotation(axes)
        T = _place(R, touches, radii_mm, drawn_mm)
        off = np.abs(_beside_mm(T, touches, radii_mm, drawn_mm))
        choices.append((int((off > BESIDE_MM).sum()), median(off), R))
    return min(choices, key=lambda choice: choice[:2])[2]


def _place(R: Floats, touches: BlockTouches, radii_mm: Floats, drawn_mm: Floats) -> Floats:
    """The placement of a rotation: the median of what the faces of each axis say."""
    axes = touches.axes(len(drawn_mm) - 5)
    off = _beside_mm(rigid(R, np.zeros(3)), touches, radii_mm, drawn_mm)
    shift = [-median(off[axes == axis]) if (axes == axis).any() else 0.0 for axis in range(3)]
    return rigid(R, np.array(shift))


def _beside_mm(T: Floats, touches: BlockTouches, radii_mm: Floats, drawn_mm: Floats) -> Floats:
    axes = touches.axes(len(drawn_mm) - 5)
    at = apply(T, touches.points_mm)
    numbers = np.arange(len(touches))
    return np.asarray(at[numbers, axes] - touches.away * radii_mm - drawn_mm[touches.faces])


def _refine(
    T: Floats, touches: BlockTouches, radii_mm: Floats, drawn_mm: Floats
) -> tuple[Floats, Floats]:
    """One step of least squares with the faces as drawn, by the touches that are near them."""
    axes = touches.axes(len(drawn_mm) - 5)
    off = _beside_mm(T, touches, radii_mm, drawn_mm)
    size = np.abs(off)
    near = size <= max(3 * sigma_from_median(size), LEAST_CUT_MM)
    at = apply(T, touches.points_mm)
    along = np.eye(3)[axes]
    columns = [-np.cross(along, at), along]
    free_tip = _shows_tip(touches, axes == 0)
    if free_tip:
        columns.append((-touches.away * _unknown(touches))[:, None])
    table = np.hstack(columns)
    step = np.asarray(np.linalg.lstsq(table[near], -off[near], rcond=1e-9)[0], np.float64)
    turn = rigid(rotation_from_vector(step[:3]), step[3:6])
    return turn @ T, radii_mm + (step[6] * _unknown(touches) if free_tip else 0.0)
