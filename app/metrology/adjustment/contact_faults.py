"""What may be wrong with all contacts together: the tip's diameter or its place, the block's size
from face to face, or that the object was moved before the pictures were taken.

One fault can look like another, and like errors of the arm's links: what stands out most by
its evidence is named.
"""

from collections.abc import Callable
from dataclasses import dataclass
from functools import partial

import numpy as np

from app.metrology.adjustment.evidence import Touches
from app.metrology.adjustment.fault_evidence import Suspect, Told, evidence_of
from app.metrology.adjustment.solve import Adjusted
from app.metrology.findings import (
    OPENING_MM,
    OPPOSITE,
    Finding,
    Limits,
    grave,
    size_agrees,
    size_off,
    size_unchecked,
)
from app.metrology.frames import Floats

# Twice the logarithm of how much likelier a fault must be than none: strong evidence (Kass and
# Raftery 1995).
EVIDENCE = 6.0
# Nothing is said of a diameter, a place or a move smaller than this.
DIAMETER_MM, PLACE_MM, MOVED_MM = 0.02, 0.03, 0.03
# How far off things are that are off, each way: worn, bent or nudged, or quite another.
SIZE_SDS_MM = (0.05, 0.5)
PLACE_SDS_MM = (0.1, 0.5)
MOVED_SDS_MM, MOVED_SDS_RAD = (0.1, 2.0), (1e-3, 2e-2)
# A turn moves points that far from its axis.
LEVER_MM = 50.0
OPPOSITE_FACES = {face for pair in OPPOSITE for face in pair}

Said = Callable[[Told], Finding | None]


@dataclass(frozen=True)
class _Fault:
    suspect: Suspect
    said: Said


def about_contact_faults(found: Adjusted, limits: Limits) -> list[Finding]:
    """The fault that is most likely, if one is, and whether the block's size was seen."""
    touches = found.problem.touches
    if touches is None or not touches.kept.any():
        return []
    pairs = _pairs(touches)
    faults = [
        _Fault(_size(np.ones(len(touches)), touches), partial(_diameter, touches, limits)),
        _Fault(_tip_place(found, touches), partial(_place, limits)),
        _Fault(_moved(found, touches), partial(_moved_said, limits)),
    ]
    faults += [
        _Fault(
            _size(np.isin(touches.features, pair).astype(np.float64), touches),
            partial(_opening, pair, limits),
        )
        for pair in pairs
    ]
    told = evidence_of(found, [fault.suspect for fault in faults])
    doubted = [
        (one.evidence, finding)
        for one, fault in zip(told, faults, strict=True)
        if one.evidence >= EVIDENCE and (finding := fault.said(one)) is not None
    ]
    named = [max(doubted, key=lambda one: one[0])[1]] if doubted else []
    if not any(face in OPPOSITE_FACES for face in touches.features):
        return named
    if not pairs:
        return [*named, size_unchecked()]
    openings = {
        pair: 2 * float(one.sizes[0])
        for pair, one in zip(pairs, told[len(told) - len(pairs) :], strict=True)
    }
    return named or [size_agrees(openings)]


def _pairs(touches: Touches) -> list[tuple[str, str]]:
    labels = np.array(touches.features)[touches.kept]
    return [pair for pair in OPPOSITE if all(face in labels for face in pair)]


def _size(outward: Floats, touches: Touches) -> Suspect:
    """The tip's centre further out on the faces for which ``outward`` (N,) is 1."""
    return Suspect(-outward[touches.kept, None], tuple(np.array([sd]) for sd in SIZE_SDS_MM))


def _tip_place(found: Adjusted, touches: Touches) -> Suspect:
    """The tip's centre elsewhere, flange frame (mm)."""
    by = np.einsum("ni,nij->nj", _normals(found, touches), touches.R_arm_flange)
    return Suspect(by[touches.kept], tuple(np.full(3, sd) for sd in PLACE_SDS_MM))


def _moved(found: Adjusted, touches: Touches) -> Suspect:
    """The object elsewhere when it was touched: turned about the contacts' middle (rad) and
    shifted (mm), arm frame."""
    normals = _normals(found, touches)
    arms = touches.tips_mm - touches.tips_mm[touches.kept].mean(axis=0)
    by = -np.column_stack([np.cross(arms, normals), normals])
    sds = tuple(np.repeat(pair, 3) for pair in zip(MOVED_SDS_RAD, MOVED_SDS_MM, strict=True))
    return Suspect(by[touches.kept], sds)


def _normals(found: Adjusted, touches: Touches) -> Floats:
    return np.asarray(touches.normals @ found.state.T_arm_obj[:3, :3].T)


def _diameter(touches: Touches, limits: Limits, told: Told) -> Finding | None:
    outward_mm = float(told.sizes[0])
    if 2 * abs(outward_mm) < DIAMETER_MM:
        return None
    remedy = "Check which tip is mounted, its diameter, and that this is the object."
    if len(set(touches.features)) == 1:  # by one plane the three are not told apart
        remedy = (
            "Check which tip is mounted, its diameter and its length, and that the object was not "
            "moved after it was touched."
        )
    given = 2 * touches.radius_mm
    told_mm, known_mm = given + 2 * outward_mm, 4 * float(np.sqrt(told.covariance[0, 0]))
    return Finding(
        grave(outward_mm, limits),
        "tip-diameter",
        f"Contacts and pictures agree better with a tip of {told_mm:.3f} mm "
        f"(± {known_mm:.3f}) than with {given:.3f} mm.",
        remedy,
    )


def _opening(pair: tuple[str, str], limits: Limits, told: Told) -> Finding | None:
    opening_mm = 2 * float(told.sizes[0])
    if abs(opening_mm) < OPENING_MM:
        return None
    return size_off(pair, opening_mm, OPENING_MM, limits)


def _place(limits: Limits, told: Told) -> Finding | None:
    off_mm = float(np.linalg.norm(told.sizes))
    if off_mm < PLACE_MM:
        return None
    x, y, z = told.sizes
    known_mm = 2 * float(np.sqrt(np.max(np.diag(told.covariance))))
    return Finding(
        grave(off_mm, limits),
        "tip-place",
        f"Contacts and pictures agree better with the tip's centre {off_mm:.2f} mm from where "
        f"the arm's file has it: by {x:+.2f}, {y:+.2f}, {z:+.2f} mm (± {known_mm:.2f}) in the "
        "flange frame. Scanned points may be off by as much.",
        "Check which tip is mounted and that its stylus is straight and tight; have its place "
        "determined anew, and touch the object again.",
    )


def _moved_said(limits: Limits, told: Told) -> Finding | None:
    turned_rad, off_mm = (float(np.linalg.norm(part)) for part in np.split(told.sizes, 2))
    if max(off_mm, LEVER_MM * turned_rad) < MOVED_MM:
        return None
    turned_deg = np.degrees(turned_rad)
    along = told.sizes[3:] / max(off_mm, 1e-9)
    known_mm = 2 * float(np.sqrt(along @ told.covariance[3:, 3:] @ along))
    text = (
        f"The pictures have the object {off_mm:.2f} mm (± {known_mm:.2f}) from where it was "
        f"touched, turned by {turned_deg:.2f}°. Scanned points may be off by as much."
    )
    if off_mm < known_mm:
        text = (
            f"The pictures have the object turned by {turned_deg:.2f}° from how it was touched. "
            "Scanned points may be off by as much."
        )
    return Finding(
        grave(max(off_mm, LEVER_MM * turned_rad), limits),
        "object-moved",
        text,
        "Fix object and arm so that neither can move, touch the object, and take the pictures "
        "again.",
    )
