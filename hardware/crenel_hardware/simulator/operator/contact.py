"""Where and how the probe's ball touches the block, and the chessboard."""

import numpy as np

from crenel_hardware.simulator.devices.kinematics import ArmModel, Floats, rotation_about
from crenel_hardware.simulator.scene.world import Board, CrenellatedBlock

BOARD = "board"
"""The chessboard's one face: its printed side."""
FACES = ("crest", "floor", "front", "back", "left", "right")
TABLE = "table"
"""What a block stands on, beside it."""
EDGE = "edge_"
"""The wall at an edge, by its number from the left, as a block's certificate counts: the left sides
of merlons are odd."""
MARGIN_MM, MARGIN_SHARE = 1.5, 0.3
"""Contacts keep this far from a face's edges, and by this share of a narrow one."""

_NORMALS = {
    "crest": (0.0, 0.0, 1.0),
    "floor": (0.0, 0.0, 1.0),
    "front": (0.0, -1.0, 0.0),
    "back": (0.0, 1.0, 0.0),
    "left": (-1.0, 0.0, 0.0),
    "right": (1.0, 0.0, 0.0),
    BOARD: (0.0, 0.0, 1.0),
    TABLE: (0.0, 0.0, 1.0),
}


def outward_normal(face: str) -> Floats:
    """(3,) outward normal of a face, in the frame of what has it."""
    if face.startswith(EDGE):
        return np.array(_NORMALS["left" if _edge_number(face) % 2 else "right"])
    return np.array(_NORMALS[face])


def _edge_number(face: str) -> int:
    return int(face.removeprefix(EDGE))


def faces_to_certify(block: CrenellatedBlock) -> tuple[str, ...]:
    """The faces that a block's certificate has a coordinate of, with the table for its base."""
    walls = (f"{EDGE}{number}" for number in range(2, len(block.edges_x_mm)))
    return ("left", *walls, "right", "front", "back", "crest", "floor", TABLE)


def reachable_faces(block: CrenellatedBlock, tip_radius_mm: float) -> tuple[str, ...]:
    """Faces that a ball of this size can touch; the floor only where a groove is wide enough."""
    widest = max(_grooves(block), key=lambda groove: groove[1] - groove[0], default=(0.0, 0.0))
    floor_fits = widest[1] - widest[0] > 2 * (tip_radius_mm + 0.5)
    return tuple(face for face in FACES if face != "floor" or floor_fits)


def _grooves(block: CrenellatedBlock) -> list[tuple[float, float]]:
    x = block.edges_x_mm
    return [(x[i], x[i + 1]) for i in range(1, len(x) - 1, 2)]


def _patches(
    block: CrenellatedBlock | Board, face: str, tip_radius_mm: float
) -> list[tuple[Floats, Floats]]:
    """Rectangles (low corner, high corner) of a face that the ball's contact may lie in.

    None where that has no such face, or the ball does not reach it.
    """
    if isinstance(block, Board):
        half = np.array([*(block.half_pattern_mm - MARGIN_MM), 0.0])
        return [(block.middle_mm - half, block.middle_mm + half)] if face == BOARD else []
    if face.startswith(EDGE):
        return [_wall(block, _edge_number(face), tip_radius_mm)]
    if face == TABLE:
        return _beside(block, tip_radius_mm)
    if face not in FACES:
        return []
    x = block.edges_x_mm
    along = _inside(block.front_y_mm, block.back_y_mm)
    up = _inside(block.base_z_mm + tip_radius_mm, block.crest_z_mm)
    merlons = [_inside(x[i], x[i + 1]) for i in range(0, len(x), 2)]
    if face == "crest":
        level = (block.crest_z_mm, block.crest_z_mm)
        return [_rectangle(across, along, level) for across in merlons]
    if face == "floor":
        s, level = tip_radius_mm + 0.5, (block.floor_z_mm, block.floor_z_mm)
        wide = [(a + s, b - s) for a, b in _grooves(block) if b - a > 2 * s]
        return [_rectangle(across, along, level) for across in wide]
    if face in ("front", "back"):
        y = block.front_y_mm if face == "front" else block.back_y_mm
        return [_rectangle(across, (y, y), up) for across in merlons]
    at = x[0] if face == "left" else x[-1]
    return [_rectangle((at, at), along, up)]


def _inside(low_mm: float, high_mm: float) -> tuple[float, float]:
    """Where contacts between two edges of a face lie."""
    margin = min(MARGIN_MM, MARGIN_SHARE * (high_mm - low_mm))
    return low_mm + margin, high_mm - margin


def _rectangle(*sides_mm: tuple[float, float]) -> tuple[Floats, Floats]:
    """The low and the high corner (3,) of what spans these sides."""
    low, high = np.array(sides_mm).T
    return low, high


def _wall(block: CrenellatedBlock, number: int, tip_radius_mm: float) -> tuple[Floats, Floats]:
    """The rectangle of a wall in a groove, above its floor."""
    x, clear = block.edges_x_mm[number - 1], block.floor_z_mm + tip_radius_mm + 0.5
    top = _inside(clear, block.crest_z_mm)[1]
    return _rectangle((x, x), _inside(block.front_y_mm, block.back_y_mm), (clear, top))


def _beside(block: CrenellatedBlock, tip_radius_mm: float) -> list[tuple[Floats, Floats]]:
    """Rectangles of the table in front of a block and behind it."""
    near, far, z = tip_radius_mm + 2.0, tip_radius_mm + 12.0, block.base_z_mm
    left, right = block.edges_x_mm[0], block.edges_x_mm[-1]
    front, back = block.front_y_mm, block.back_y_mm
    return [
        (np.array([left, front - far, z]), np.array([right, front - near, z])),
        (np.array([left, back + near, z]), np.array([right, back + far, z])),
    ]


def choose_contact_point(
    block: CrenellatedBlock | Board,
    face: str,
    index: int,
    tip_radius_mm: float,
    rng: np.random.Generator,
) -> Floats:
    """(3,) the ``index``-th place to touch on a face, in the frame of the block or the board.

    Successive places fill the face evenly, patch after patch; ``rng`` shifts each a little.

    Raises:
        KeyError: no such face, or the ball does not reach it.
    """
    patches = _patches(block, face, tip_radius_mm)
    if not patches:
        raise KeyError(f"the face {face!r} cannot be touched")
    low, high = patches[index % len(patches)]
    turn = index // len(patches) + 1
    golden = np.array([0.7548776662466927, 0.5698402909980532])
    even = (0.5 + golden * turn + 0.13 * (index % len(patches))) % 1.0
    even = np.clip(even + rng.uniform(-0.04, 0.04, 2), 0.0, 1.0)
    free = np.flatnonzero(outward_normal(face) == 0.0)
    spot = low.copy()
    for share, axis in zip(even, free, strict=True):
        spot[axis] = low[axis] + share * (high[axis] - low[axis])
    return np.asarray(spot)


def contact_pose(
    arm: ArmModel,
    T_arm_obj: Floats,
    face: str,
    spot_mm: Floats,
    gap_mm: float,
    rng: np.random.Generator,
    flange_x: Floats | None = None,
    sway_rad: float = 0.18,
) -> Floats:
    """``T_arm_flange`` (4, 4) with the ball's centre ``gap_mm`` off a spot of a face.

    The stylus comes from above and from outside of the face, turned by ``sway_rad`` or
    so differently each time, as an operator does. ``flange_x`` (3,): where the flange's x
    axis points about, in the arm frame; along the block's x where not given.
    """
    up, normal = np.array([0.0, 0.0, 1.0]), outward_normal(face)
    lean = up + 0.4 * (1.0 - normal[2]) * normal
    sway = rng.normal(0.0, sway_rad, 3)
    if face == "floor" or face.startswith(EDGE):
        # a groove leaves the stylus no room across
        lean, sway[0] = up, 0.0
    away = lean + sway
    away /= np.linalg.norm(away)
    z = -(T_arm_obj[:3, :3] @ away)
    x = T_arm_obj[:3, 0] if flange_x is None else flange_x
    x = x - (x @ z) * z
    x /= np.linalg.norm(x)
    T = np.eye(4)
    T[:3, :3] = np.column_stack([x, np.cross(z, x), z])
    T = T @ rotation_about("z", float(rng.normal(0.0, 2 * sway_rad)))
    centre = T_arm_obj[:3, :3] @ (spot_mm + gap_mm * normal) + T_arm_obj[:3, 3]
    T[:3, 3] = centre - T[:3, :3] @ np.array(arm.tip_mm)
    return T
