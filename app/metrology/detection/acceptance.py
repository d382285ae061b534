"""Whether the object that was found is the one of the certificate; if not, why not, in words."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from app.metrology.camera import project
from app.metrology.crenellated import Crenellated
from app.metrology.detection.edge_strays import missized, overrun
from app.metrology.detection.edge_survey import Survey, without
from app.metrology.detection.locate import Search
from app.metrology.detection.objection import Objection
from app.metrology.detection.picture import BLURRED, PictureFinding
from app.metrology.detection.visibility import seen
from app.metrology.frames import Floats
from app.metrology.refusal import Refusal

# An edge that lies this many standard deviations off is not the certificate's.
_SIGMAS = 5.0
# What a camera model and an edge's finish may do to a whole edge, over the longer side.
_MODEL = 0.05 / 1280
# All edges together may lie off by this many standard deviations.
_SPREAD = 3.0
# Pixels of today's sensors are square; by how much a fitted camera may differ.
_SQUARE = 0.005
# Of the drawn edges' length, how much must show: faces of equal brightness hide some.
_LEAST_SHOWN = 0.35
# Of the points that show, how many must agree with the edge they were looked for on.
_LEAST_AGREEING = 0.8
# and of the edges of floors and base.
_LEAST_LOWER = 0.05
# More than any lens of a sensor is bent.
_K1, _K2 = 1.2, 3.0
# Share of the parts of edges that may be left out because something moved each alone.
_ALONE = 0.1
# A wrong size that the camera takes up in part moves others too: so far they may lie off.
_REST_SIGMAS = 3.0
# How far edges may lie off on average, over the blur.
_STRAIN_BLURS = 0.3
# Share of the edges in the frame that makes the object whole.
_WHOLE = 0.9
# Sides of merlons that tell which part of the object is seen.
_SIDES = 4
# Below this support at the small scale nothing like the block was found.
LEAST_SUPPORT = 0.5
# Share of straight segments in three perpendicular directions that makes a block.
_BLOCK_LIKE = 0.7


def refuse_unusable(findings: list[PictureFinding], clipped: NDArray[np.bool_]) -> None:
    """Refuses a black picture and one that is clipped all over.

    Raises:
        Refusal: ``image-dark``, ``image-saturated``.
    """
    for finding in findings:
        hopeless = finding.code == "image-dark" or (
            finding.code == "image-saturated" and float(clipped.mean()) > 0.5
        )
        if hopeless:
            raise Refusal(finding.code, finding.text, "", finding.remedy)


def refuse_bad_picture(findings: list[PictureFinding], consequence: str) -> None:
    """Refuses a picture that is overexposed or blurred, where that is why a step failed.

    Raises:
        Refusal: ``image-saturated``, ``image-blurred``.
    """
    for finding in findings:
        if finding.code in ("image-saturated", "image-blurred"):
            raise Refusal(finding.code, f"{finding.text}: {consequence}", "", finding.remedy)


def unfound(found: Search) -> Refusal:
    """The refusal for a picture in which nothing like the block was found."""
    return Refusal(
        "object-not-found",
        "no crenellated object was found in the picture",
        f"its {found.segment_count} straight edges do not make a block",
        "bring the whole object into view, from its front and above, and light it evenly",
    )


def block_like(found: Search) -> bool:
    """Whether most straight segments follow three perpendicular directions."""
    return found.segment_count >= 12 and found.explained >= _BLOCK_LIKE


def unclear(block: Crenellated, why: str) -> Refusal:
    """The refusal for a block that is not seen well enough to be sure of it."""
    return Refusal(
        "object-unclear",
        f"{block.name} is not seen well enough to be sure of it",
        why,
        "light it from the front and above so that crests, floors and front differ, come"
        " nearer, and clear away what stands before it",
    )


def mismatch(block: Crenellated, why: str) -> Refusal:
    """The refusal for a block that is not the certificate's."""
    return Refusal(
        "object-does-not-match",
        f"the object in the picture does not match the certificate of {block.name}"
        f" ({block.serial_number})",
        why,
        "choose the object that is before the camera; if it is this one, look whether its"
        " edges are clean and undamaged",
    )


def mirror_refusal(block: Crenellated, share: float) -> Refusal:
    """The refusal for a block that reads the wrong way round."""
    if share < _WHOLE:
        return cut_off(block, share, "what it shows reads rather like the object's mirror image")
    return Refusal(
        "object-mirrored",
        f"the merlons of {block.name} read in the mirrored order",
        "the picture is mirrored, or the camera looks at the object's back",
        "turn off the camera's mirroring, or turn the object so that its front faces the camera",
    )


def ambiguous(block: Crenellated, share: float) -> Refusal:
    """The refusal for a picture that more than one placing explains."""
    if share < _WHOLE:
        return cut_off(block, share, "what it shows could be more than one part of the object")
    return Refusal(
        "object-ambiguous",
        f"the picture of {block.name} can be read in more than one way",
        "its merlons read alike from either side",
        "use an object whose merlons differ in width",
    )


def cut_off(block: Crenellated, share: float, why: str) -> Refusal:
    """The refusal for a block of which the frame shows too little."""
    return Refusal(
        "object-cut-off",
        f"the frame shows only {100 * share:.0f} % of {block.name}'s visible edges",
        why,
        "move the sensor until the whole object is in the picture",
    )


def refuse_blurred(found: Survey) -> None:
    """Refuses a picture whose edges are too wide for its lines to keep apart.

    Raises:
        Refusal: ``image-blurred``.
    """
    limit_px = BLURRED * max(found.camera.width_px, found.camera.height_px)
    if found.blur_px > limit_px:
        # From a tenth to nine tenths of its height, a step is 2.56 standard deviations wide.
        raise Refusal(
            "image-blurred",
            f"the picture is blurred: its edges are {2.56 * found.blur_px:.0f} px wide,"
            f" at most {2.56 * limit_px:.0f} px can be measured",
            "",
            "focus the camera on the object, bring it into the working distance, hold it still",
        )


def symmetric(block: Crenellated) -> bool:
    """Whether the block reads the same both ways, to ten times its uncertainty."""
    x = np.array(block.edges_x_mm)
    there, back = x - x[0], x[-1] - x[::-1]
    return bool(np.abs(there - back).max() < 10 * max(block.standard_uncertainty_mm, 0.001))


def judged(grey: Floats, found: Survey, certificate_mm: float) -> tuple[Survey, Objection | None]:
    """The survey without single edges that a shadow or damage moved, and what speaks against it.

    Args:
        grey: (H, W) the picture, NaN where it must not count.
        found: the edges measured in it.
        certificate_mm: standard uncertainty of the block's coordinates.
    """
    against = _unclear(found) or _implausible(found) or missized(grey, found)
    against = against or overrun(grey, found)
    if against is not None:
        return found, against
    parts = _parts(found, certificate_mm)
    alone = [part for part in _displaced(parts) if _others_agree(found, part, parts)]
    rest = max((part.ratio for part in parts if part not in alone), default=0.0)
    if alone and len(alone) <= _ALONE * len(parts) and rest < _REST_SIGMAS:
        kept = without(found, [part.number for part in alone], certificate_mm)
        if kept is not None:
            found, parts = kept, _parts(kept, certificate_mm)
    if not parts:
        return found, Objection("too few of its edges could be measured")
    astray = _displaced(parts)
    if not astray:
        return found, _strained(found, parts)
    worst = max(astray, key=lambda part: part.ratio)
    return found, Objection(
        f"its edge {worst.name} lies {worst.distance_um:.0f} µm from where the certificate puts it",
        True,
        tuple({part.edge for part in astray}),
    )


def _unclear(found: Survey) -> Objection | None:
    """Too little of the block shows to say whether it is the one."""
    at = found.at
    shown = float(at.length_px[found.shows].sum()) / max(float(at.length_px.sum()), 1e-9)
    missing = tuple(int(edge) for edge in set(at.edge) - set(at.edge[found.used]))
    if shown < _LEAST_SHOWN:
        text = f"only {100 * shown:.0f} % of its visible edges show in the picture"
        return Objection(text, edges=missing)
    agreeing = float(found.used.sum()) / max(int(found.shows.sum()), 1)
    if agreeing < _LEAST_AGREEING:
        text = f"only {100 * agreeing:.0f} % of the edge points lie on its edges"
        return Objection(text, edges=missing)
    if _lower_shown(found) < _LEAST_LOWER:
        text = "none of the edges of its floors and its base shows in the picture"
        return Objection(text, edges=missing)
    return None


def _implausible(found: Survey) -> Objection | None:
    """A camera that no sensor has."""
    off_square = abs(found.camera.matrix[1, 1] / found.camera.matrix[0, 0] - 1)
    if off_square > _SQUARE:
        return Objection(
            "its edges would fit only if the camera's pixels were"
            f" {100 * off_square:.1f} % out of square",
            True,
        )
    k1, k2 = found.camera.distortion[:2]
    if abs(k1) > _K1 or abs(k2) > _K2:
        return Objection(
            f"its edges would fit only a lens distorted by k1 = {k1:.1f}, k2 = {k2:.1f}", True
        )
    return None


def _lower_shown(found: Survey) -> float:
    """Share of the lower edges' length that shows: without them any height would do."""
    lower = np.array([name.startswith(("floor", "base")) for name in found.frame.names])
    rows = lower[found.at.edge]
    shown = float(found.at.length_px[rows & found.used].sum())
    return shown / max(float(found.at.length_px[rows].sum()), 1e-9)


@dataclass(frozen=True)
class _Part:
    """A measured part of an edge: its number and edge, how far it lies from where the camera
    draws it, and that over what image noise, certificate and camera model leave it."""

    number: int
    edge: int
    name: str
    distance_um: float
    distance_px: float
    ratio: float


def _strained(found: Survey, parts: list[_Part]) -> Objection | None:
    """All edges lie off by more than texture explains: the camera had to take up a wrong size."""
    usual_px = float(np.median([part.distance_px for part in parts])) / 0.6745
    if usual_px < _STRAIN_BLURS * max(1.0, found.blur_px):
        return None
    worst = max(parts, key=lambda part: part.distance_px)
    return Objection(
        f"its edges lie {usual_px:.1f} px off on average, and {worst.name}"
        f" {worst.distance_um:.0f} µm, from where the certificate puts them",
        True,
        (worst.edge,),
    )


def _parts(found: Survey, certificate_mm: float) -> list[_Part]:
    at = found.at
    model_px = _MODEL * max(found.camera.width_px, found.camera.height_px)
    depth = (at.points_mm @ found.camera.rotation.T + found.camera.translation_mm)[:, 2]
    parts = []
    for part in np.unique(at.part[found.used]):
        rows = np.flatnonzero(found.used & (at.part == part))
        if len(rows) < 4:
            continue
        mm_per_px = float(np.median(depth[rows])) / found.camera.matrix[0, 0]
        off = float(np.median(found.off_px[rows]))
        own = 1.25 * float(np.median(found.sigma_px[rows])) / np.sqrt(len(rows))
        allowed = np.sqrt(own**2 + (certificate_mm / mm_per_px) ** 2 + model_px**2)
        edge = int(at.edge[rows[0]])
        parts.append(
            _Part(
                int(part),
                edge,
                found.frame.names[edge],
                1000 * abs(off) * mm_per_px,
                abs(off),
                float(abs(off) / allowed),
            )
        )
    return parts


def _displaced(parts: list[_Part]) -> list[_Part]:
    """The parts that lie too far from where the camera draws them; all where most do."""
    # Texture along the edges moves each as a whole; one that is moved more stands out.
    spread = max(1.0, float(np.median([part.ratio for part in parts] or [0.0])) / 0.6745)
    if spread > _SPREAD:
        return parts
    return [part for part in parts if part.ratio > _SIGMAS * spread]


def _others_agree(found: Survey, astray: _Part, parts: list[_Part]) -> bool:
    """Whether in both planes of a displaced edge others lie where they should.

    A wrong size moves all edges of its plane. Only those count that a shift of the
    plane would move at least half as far in the picture.
    """
    displaced = {part.number for part in _displaced(parts)}
    frame = found.frame
    both = np.stack([frame.starts_mm, frame.ends_mm], axis=1)
    for axis in np.flatnonzero(both[astray.edge, 0] == both[astray.edge, 1]):
        shift = 1000.0 * _shift_px(found, astray, int(axis))
        if shift < 1e-6:
            continue
        level = both[astray.edge, 0, axis]
        if not any(
            part.number not in displaced
            and bool((both[part.edge, :, axis] == level).all())
            and 1000.0 * _shift_px(found, part, int(axis)) > 0.5 * shift
            for part in parts
        ):
            return False
    return True


def _shift_px(found: Survey, part: _Part, axis: int) -> float:
    """How far, px, a part moves across itself when its edge is shifted by 1 µm along an axis."""
    row = int(np.flatnonzero(found.at.part == part.number)[0])
    ahead = found.at.points_mm[row] + 1e-3 * np.eye(3)[axis]
    moved = project(found.camera, ahead[None])[0] - found.at.uv_px[row]
    return abs(float(moved @ found.at.normal[row]))


def refuse_cut_off(found: Survey, block: Crenellated, share: float) -> None:
    """Refuses a picture whose frame leaves too little of the block.

    A camera needs both levels, and four of the crests' sides: as many as two merlons have.
    ``share``: of the visible edges in the frame.

    Raises:
        Refusal: ``object-cut-off``.
    """
    names = {found.frame.names[edge] for edge in found.at.edge[found.used]}
    sides = sum(
        f"crest:{i}:{side}" in names for i in range(block.merlon_count) for side in ("L", "R")
    )
    level = any(name.startswith("floor:") for name in names)
    if share < _WHOLE and (sides < _SIDES or not level or share < 0.4):
        raise cut_off(block, share, "a camera needs both levels and four sides of its merlons")


def in_frame(found: Survey) -> float:
    """Share of the visible edges' length that lies within the picture."""
    parts = seen(found.frame, found.camera.centre_mm)
    begin = found.frame.starts_mm[parts.edge]
    along = found.frame.ends_mm[parts.edge] - begin
    span = (parts.end - parts.start) * np.linalg.norm(along, axis=1)
    total, inside = 0.0, 0.0
    for share in (np.arange(20) + 0.5) / 20:
        at = parts.start + share * (parts.end - parts.start)
        uv = project(found.camera, begin + at[:, None] * along)
        within = (uv >= 0).all(axis=1)
        within &= (uv < [found.camera.width_px, found.camera.height_px]).all(axis=1)
        total += float(span.sum())
        inside += float(span[within].sum())
    return inside / max(total, 1e-9)
