"""The crenellated object in a calibration image: its edges, its corners, and the camera they show.

No guess from the operator is needed. The object is found in a small picture
(``locate``), its edges are measured in the full one (``edge_survey``) with a camera
fitted to all of them at once, and the result is accepted only if every edge lies
where the certificate puts it (``acceptance``).
"""

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from app.metrology.camera import Camera, project
from app.metrology.crenellated import Crenellated
from app.metrology.crenellated import corners as corners_of
from app.metrology.detection import acceptance
from app.metrology.detection.edge_survey import Survey, survey
from app.metrology.detection.identify import mirrored
from app.metrology.detection.locate import Located, Search, locate, working_picture
from app.metrology.detection.picture import (
    Image,
    PictureFinding,
    edge_blur_px,
    grey_picture,
    picture_findings,
)
from app.metrology.detection.stripe_mask import stripe_mask
from app.metrology.detection.visibility import seen, visible_corners, wireframe
from app.metrology.frames import Floats
from app.metrology.refusal import Refusal
from app.metrology.stripe import Stripe

__all__ = [
    "Corner",
    "EdgePoints",
    "ObjectDetection",
    "PictureFinding",
    "detect_object",
    "picture_findings",
]

# Longer sides, in pixels, at which the object is looked for: small objects want a larger
# picture, soft and noisy pictures a smaller one.
_WORKING_PX = (640, 1280, 320)
# A placing this much less supported than the best is no rival.
_RIVAL = 0.85
_RIVALS = 4
# A reading the other way round with this share of the best's support leaves it in doubt.
_DOUBTFUL = 0.95
# A placing so well supported is the object, or one very like it; no other scale will tell more.
_SURE = 0.8
# Nor is one that explains less than this share of what the best does.
_MORE = 0.88
# Edges that cross at less than this make no corner.
_FLATTEST_RAD = np.deg2rad(8.0)
_WORST_CORNER_PX = 1.0


@dataclass(frozen=True)
class Corner:
    """A corner of the block in the image, px, with its covariance (2, 2)."""

    name: str
    u: float
    v: float
    covariance_px2: Floats


@dataclass(frozen=True)
class EdgePoints:
    """Measured points (N, 2) of one edge; each is free along the edge, and across it,
    along ``normal`` (N, 2), has the standard deviation ``sigma_px`` (N,)."""

    edge: str
    uv_px: Floats
    normal: Floats
    sigma_px: Floats


@dataclass(frozen=True)
class ObjectDetection:
    """The block in an image. ``camera`` has the object frame as its sensor frame;
    ``rms_px`` is that of the edge points about it, along their normals."""

    corners: tuple[Corner, ...]
    edges: tuple[EdgePoints, ...]
    camera: Camera
    rms_px: float


def detect_object(
    ambient: Image, block: Crenellated, stripe: Stripe | None = None
) -> ObjectDetection:
    """Finds, identifies and measures the block in one image, without a starting guess.

    Args:
        ambient: (H, W) grey, 8 to 16 bits, with room light (and the laser's, if
            ``stripe`` is given).
        block: the block by its certificate.
        stripe: the laser's points in this image; its pixels are left out.

    Raises:
        Refusal: ``image-not-grey``, ``image-dark``, ``image-saturated``,
            ``image-blurred``, ``object-not-found``, ``object-does-not-match``,
            ``object-mirrored``, ``object-ambiguous``, ``object-cut-off``.
    """
    grey, clipped = grey_picture(ambient)
    findings = picture_findings(ambient)
    acceptance.refuse_unusable(findings, clipped)
    lit = None if stripe is None or len(stripe.u) == 0 else stripe_mask(grey, stripe)
    hidden = clipped if lit is None else clipped | lit
    refusal: Refusal | None = None
    for longer_px in _WORKING_PX:
        small, ignore, scale = working_picture(grey, lit, longer_px)
        found = locate(small, ignore, block)
        try:
            return _accepted(grey, hidden, found, scale, block, findings)
        except Refusal as declined:
            refusal = refusal or declined
            if declined.code not in ("object-not-found", "object-does-not-match"):
                refusal = declined
                break
            if found.found and found.found[0].support > _SURE:
                break
    assert refusal is not None
    raise refusal


def _accepted(
    grey: Floats,
    hidden: NDArray[np.bool_],
    found: Search,
    scale: float,
    block: Crenellated,
    findings: list[PictureFinding],
) -> ObjectDetection:
    """The one placing that every measured edge agrees with."""
    if not found.found or found.found[0].support < acceptance.LEAST_SUPPORT:
        acceptance.refuse_bad_picture(findings, "the object was not found")
        raise acceptance.unfound(found, block)
    good, why = _matching(grey, hidden, found, scale, block)
    good = [one for one in good if _explained(one[1]) > _MORE * _explained(good[0][1])]
    if not good:
        acceptance.refuse_bad_picture(findings, "its edges cannot be measured")
        raise acceptance.mismatch(block, why)
    measured = good[0][1]
    share = acceptance.in_frame(measured)
    other_way = [one.support for one in found.found if one.mirrored != good[0][0].mirrored]
    doubtful = max(other_way, default=0.0) > _DOUBTFUL * good[0][0].support
    if len(good) > 1 or doubtful or acceptance.symmetric(block):
        raise acceptance.ambiguous(block, share)
    if good[0][0].mirrored:
        raise acceptance.mirror_refusal(block, share)
    acceptance.refuse_blurred(measured)
    acceptance.refuse_cut_off(measured, block, share)
    return _detection(measured, block)


def _matching(
    grey: Floats, hidden: NDArray[np.bool_], found: Search, scale: float, block: Crenellated
) -> tuple[list[tuple[Located, Survey]], str]:
    """The different placings that all edges agree with, best first; if none, why not."""
    best = found.found[0].support
    blur_px = edge_blur_px(grey)
    masked = np.where(hidden, np.nan, grey)
    good: list[tuple[Located, Survey]] = []
    why = ""
    for rival in found.found[:_RIVALS]:
        start = _enlarged(rival.camera, scale, grey.shape)
        if rival.support < _RIVAL * best or _known(start, rival.mirrored, good, block):
            continue
        measured = survey(
            grey,
            hidden,
            wireframe(mirrored(block) if rival.mirrored else block),
            start,
            max(3.0, 2.0 / scale),
            blur_px,
            block.standard_uncertainty_mm,
        )
        against = "too few of its edges could be measured"
        if measured is not None:
            against = acceptance.disagreement(masked, measured, block.standard_uncertainty_mm)
            if not against and not _known(measured.camera, rival.mirrored, good, block):
                good.append((rival, measured))
        why = why or against
    return sorted(good, key=lambda one: -_explained(one[1])), why


def _explained(measured: Survey) -> float:
    """Length, px, of the edges that the picture shows where they are drawn."""
    return float(measured.at.length_px[measured.used].sum())


def _known(
    camera: Camera, reverse: bool, good: list[tuple[Located, Survey]], block: Crenellated
) -> bool:
    """Whether a placing draws the crests where an accepted one does, to a hundredth."""
    points = np.array([at for name, at in corners_of(block).items() if name.startswith("crest")])
    for other, measured in good:
        if other.mirrored != reverse:
            continue
        apart = project(camera, points) - project(measured.camera, points)
        if np.hypot(*apart.T).max() < 0.01 * max(camera.width_px, camera.height_px):
            return True
    return False


def _enlarged(camera: Camera, scale: float, shape: tuple[int, ...]) -> Camera:
    """The camera of the small picture for the full one; pixels' centres are whole numbers."""
    height, width = shape[:2]
    K = camera.matrix.copy()
    across, down = width / camera.width_px, height / camera.height_px
    K[0] *= across
    K[1] *= down
    K[0, 2] += 0.5 * (across - 1)
    K[1, 2] += 0.5 * (down - 1)
    return replace(camera, matrix=K, width_px=width, height_px=height)


def _detection(measured: Survey, block: Crenellated) -> ObjectDetection:
    at = measured.at
    edges = []
    for edge in np.unique(at.edge[measured.used]):
        rows = np.flatnonzero(measured.used & (at.edge == edge))
        edges.append(
            EdgePoints(
                measured.frame.names[edge],
                measured.uv_px[rows],
                at.normal[rows],
                measured.sigma_px[rows],
            )
        )
    off = measured.off_px[measured.used]
    return ObjectDetection(
        _corners(measured, block),
        tuple(edges),
        measured.camera,
        float(np.sqrt(np.mean(off**2))),
    )


def _corners(measured: Survey, block: Crenellated) -> tuple[Corner, ...]:
    """Corners where two measured edges meet, with their covariance."""
    camera, frame = measured.camera, measured.frame
    parts = seen(frame, camera.centre_mm)
    begin = frame.starts_mm[parts.edge]
    along = frame.ends_mm[parts.edge] - begin
    ends = np.stack(
        [begin + parts.start[:, None] * along, begin + parts.end[:, None] * along], axis=1
    )
    lines = {}
    for part in np.unique(measured.at.part[measured.used]):
        line = _line(measured, int(part))
        if line is not None:
            lines[int(part)] = line
    found = []
    shown = visible_corners(block, camera.centre_mm)
    for name, point in corners_of(block).items():
        if name not in shown:
            continue
        at = project(camera, point[None])[0]
        if (at < 0).any() or at[0] > camera.width_px - 1 or at[1] > camera.height_px - 1:
            continue
        touching = np.flatnonzero((np.abs(ends - point).max(axis=2) < 1e-6).any(axis=1))
        met = [lines[int(k)] for k in touching if int(k) in lines]
        corner = _meeting(name, at, met)
        if corner is not None:
            found.append(corner)
    return tuple(found)


@dataclass(frozen=True)
class _Line:
    """One part's measured edge as offsets, straight along the part, from the camera's edge."""

    middle: Floats  # (2,) px, where the offset is best known
    direction: Floats  # (2,)
    offset_px: float
    slope: float
    variance_offset: float
    variance_slope: float


def _line(measured: Survey, part: int) -> _Line | None:
    rows = np.flatnonzero(measured.used & (measured.at.part == part))
    if len(rows) < 3:
        return None
    uv, off = measured.at.uv_px[rows], measured.off_px[rows]
    weight = 1 / measured.sigma_px[rows] ** 2
    normal = measured.at.normal[rows].mean(axis=0)
    direction = np.array([normal[1], -normal[0]]) / np.linalg.norm(normal)
    middle = weight @ uv / weight.sum()
    s = (uv - middle) @ direction
    spread = float(weight @ s**2)
    if spread <= 0:
        return None
    return _Line(
        middle,
        direction,
        float(weight @ off / weight.sum()),
        float((weight * s) @ off / spread),
        float(1 / weight.sum()),
        float(1 / spread),
    )


def _meeting(name: str, at: Floats, lines: list[_Line]) -> Corner | None:
    """Least-squares crossing (weighted) of the edges that meet at ``at`` (2,)."""
    information = np.zeros((2, 2))
    pull = np.zeros(2)
    for line in lines:
        s = float((at - line.middle) @ line.direction)
        variance = line.variance_offset + s**2 * line.variance_slope
        normal = np.array([-line.direction[1], line.direction[0]])
        information += np.outer(normal, normal) / variance
        pull += normal * (line.offset_px + s * line.slope) / variance
    crossings = [
        abs(a.direction[0] * b.direction[1] - a.direction[1] * b.direction[0])
        for a in lines
        for b in lines
    ]
    if not crossings or max(crossings) < np.sin(_FLATTEST_RAD):
        return None
    covariance: Floats = np.asarray(np.linalg.inv(information), dtype=np.float64)
    if float(np.linalg.eigvalsh(covariance)[-1]) > _WORST_CORNER_PX**2:
        return None
    u, v = at + covariance @ pull
    return Corner(name, float(u), float(v), covariance)
