"""Touches of a block's faces by a measuring machine or an arm, and what they say of its faces.

Each touch puts its face at a coordinate of the block's frame, one radius of the tip beside the
tip's centre. The faces of one axis are parallel planes, whose common direction is found with them.
Errors that touches share, such as those of an arm's links, are unknowns of known size: so many
touches do not average them away, and what moves the whole block does no harm.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from crenel.metrology.targets.block_readings import TIP, face_axis
from crenel.metrology.transforms import Floats, apply, rigid, rotation_from_vector

LEVER_MM = 30.0
"""Rotations of the block are solved as lengths at this lever, about its size."""
LEAST_SD_MM = 1e-5
PLANE_LEAST = 4
"""Touches of a face that show its form; three lie on a plane."""


@dataclass(frozen=True)
class TouchTip:
    """A tip's diameter as certified, with its standard uncertainty: infinite where unknown.

    Of points that the machine has compensated, the diameter is 0, and the uncertainty what the
    compensation leaves.
    """

    diameter_mm: float = 0.0
    sd_mm: float = 0.0

    @property
    def is_unknown(self) -> bool:
        return not np.isfinite(self.sd_mm)

    @property
    def name(self) -> str:
        """That of its column among the tools; the unknown one is that of readings by tip."""
        return TIP if self.is_unknown else f"{TIP} {self.diameter_mm:.4f} mm"


@dataclass(frozen=True, eq=False)
class BlockTouches:
    """N touches in the frame of the machine.

    ``faces`` (N,) are indices among the coordinates of a block; ``away`` (N,) is 1 or -1: to which
    side along the axis the tip lies. ``points_mm`` (N, 3) are tip centres, or points of the surface
    where the tip's diameter is 0, with the covariance of each by itself (N, 3, 3). ``tip`` (N,)
    numbers ``tips``. ``shared_mm`` (N, 3, K) is how far each of K shared errors moves a touch, for
    one standard deviation. ``outward`` (N, 3) are directions out of the surface, NaN where not
    stated.
    """

    faces: NDArray[np.int64]
    away: Floats
    points_mm: Floats
    covariances_mm2: Floats
    tips: tuple[TouchTip, ...]
    tip: NDArray[np.int64]
    shared_mm: Floats
    outward: Floats

    def __len__(self) -> int:
        return len(self.faces)

    def axes(self, edge_count: int) -> NDArray[np.int64]:
        """(N,) the axis along which each face is measured."""
        return np.array([face_axis(int(face), edge_count) for face in self.faces], dtype=np.int64)

    def radii_mm(self) -> Floats:
        """(N,) from the face to the touch, as far as the tip's diameter is known."""
        known = np.array([0.0 if one.is_unknown else one.diameter_mm for one in self.tips])
        return np.asarray(known[self.tip] / 2)


@dataclass(frozen=True, eq=False)
class TouchRows:
    """Linear equations of N touches, each over its standard deviation.

    Derivatives by the coordinates of the block (N, B), by tips' diameters (N, T) in the order of
    ``BlockTouches.tips``, by a rotation of the block (N, 3) in mm at ``LEVER_MM``, and by the
    shared errors (N, K) in their standard deviations; ``off`` (N,) is what the touches put their
    faces beside the drawing.
    """

    by_coordinates: Floats
    by_tips: Floats
    by_rotation: Floats
    by_shared: Floats
    off: Floats
    sds_mm: Floats


def touch_rows(touches: BlockTouches, T_obj_machine: Floats, drawn_mm: Floats) -> TouchRows:
    """The equations of all touches with the block about where it is.

    Args:
        T_obj_machine: (4, 4), of which only the rotation matters.
        drawn_mm: (B,) coordinates that the drawing has.
    """
    edges, count = len(drawn_mm) - 5, len(touches)
    axes = touches.axes(edges)
    at = apply(T_obj_machine, touches.points_mm)
    along = T_obj_machine[:3, :3][axes]
    variances = np.einsum("ni,nij,nj->n", along, touches.covariances_mm2, along)
    sds = np.sqrt(np.maximum(variances, LEAST_SD_MM**2))
    numbers = np.arange(count)
    by_coordinates, by_tips = np.zeros((count, len(drawn_mm))), np.zeros((count, len(touches.tips)))
    by_coordinates[numbers, touches.faces] = 1.0
    by_tips[numbers, touches.tip] = touches.away / 2
    by_rotation = np.cross(np.eye(3)[axes], at) / LEVER_MM
    by_shared = np.einsum("ni,nik->nk", along, touches.shared_mm)
    off = at[numbers, axes] - touches.away * touches.radii_mm() - drawn_mm[touches.faces]
    own = sds[:, None]
    return TouchRows(
        by_coordinates / own, by_tips / own, by_rotation / own, by_shared / own, off / sds, sds
    )


def turn_block(T_obj_machine: Floats, rotation_mm: Floats) -> Floats:
    """The placement (4, 4) after a rotation (3,) as of ``TouchRows`` was found."""
    turn = rigid(rotation_from_vector(rotation_mm / LEVER_MM), np.zeros(3))
    return np.asarray(turn @ T_obj_machine)


@dataclass(frozen=True)
class FaceForm:
    """What the touches of one face are off its own plane, and that off the block's axis."""

    face: int
    away: int
    touches: int
    flatness_mm: float | None
    """Largest minus smallest distance from their own least-squares plane; None of too few."""
    out_of_parallel_mm: float | None
    """By how much that plane rises, over the touched area, against the axis of the block."""


def face_forms(
    touches: BlockTouches, T_obj_machine: Floats, kept: NDArray[np.bool_], edge_count: int
) -> tuple[FaceForm, ...]:
    """The form of each touched face, by the touches that are kept (N,)."""
    at = apply(T_obj_machine, touches.points_mm)
    forms = []
    for face, away in sorted(set(zip(touches.faces.tolist(), touches.away.tolist(), strict=True))):
        own = at[(touches.faces == face) & (touches.away == away) & kept]
        form: tuple[float, float] | tuple[None, None] = (None, None)
        if len(own) >= PLANE_LEAST:
            form = _plane_form(own, face_axis(face, edge_count)) or (None, None)
        forms.append(FaceForm(face, int(away), len(own), *form))
    return tuple(forms)


def _plane_form(points_mm: Floats, axis: int) -> tuple[float, float] | None:
    """Range off the plane through points (N, 3), and what it rises; None if they lie on a line."""
    others = [k for k in range(3) if k != axis]
    middle = points_mm - points_mm.mean(axis=0)
    across = middle[:, others]
    singular = np.linalg.svd(across, compute_uv=False)
    if singular[1] < 0.02 * singular[0]:
        return None
    slopes = np.linalg.lstsq(across, middle[:, axis], rcond=None)[0]
    return float(np.ptp(middle[:, axis] - across @ slopes)), float(np.ptp(across @ slopes))
