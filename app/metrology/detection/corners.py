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
from app.metrology.detection import acceptance, refusals
from app.metrology.detection.corner_fit import Corner, corners_where_edges_meet
from app.metrology.detection.edge_sizes import unseen
from app.metrology.detection.edge_survey import Survey, pulled, softened, survey
from app.metrology.detection.evidence import DetectionRefusal, with_evidence
from app.metrology.detection.identify import mirrored
from app.metrology.detection.locate import Cleaning, Located, Search, locate, working_picture
from app.metrology.detection.objection import Objection
from app.metrology.detection.picture import (
    Image,
    PictureFinding,
    edge_blur_px,
    grey_picture,
    noisy,
    picture_findings,
)
from app.metrology.detection.stripe_mask import stripe_mask
from app.metrology.detection.visibility import wireframe
from app.metrology.frames import Floats
from app.metrology.refusal import Refusal
from app.metrology.stripe import Stripe

__all__ = [
    "Corner",
    "DetectionRefusal",
    "EdgePoints",
    "ObjectDetection",
    "PictureFinding",
    "detect_object",
    "picture_findings",
]

# Longer sides, in pixels, at which the object is looked for, and how the picture is freed of
# texture there: small objects want a larger picture, soft and noisy pictures a smaller one.
_ATTEMPTS: tuple[tuple[int, Cleaning], ...] = (
    (640, "coarse"),
    (640, "fine"),
    (320, "coarse"),
    (640, "speckled"),
    (320, "fine"),
    (1280, "fine"),
)
# A placing this much less supported than the best is no rival.
_RIVAL = 0.85
_RIVALS = 4
# Tool marks leave even the right placing little support; with less it is not worth measuring.
_LEAST_SUPPORT = 0.15
# Placings that draw the crests alike to so much of the picture's longer side are the same.
_SAME, _VERY_SAME = 0.01, 0.0005
# A reading the other way round with this share of the best's support leaves it in doubt.
_DOUBTFUL = 0.95
_SURE = 0.8
_MOST = 0.6
# A try that draws this share of another's edges says as much.
_AS_MUCH = 0.8
# Nor is one that explains less than this share of what the best does.
_MORE = 0.88

# A camera's eleven numbers need as many corners, two numbers each.
_LEAST_CORNERS = 6

_NOTHING = Search((), 0.0, np.empty((0, 4)))


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
    ``rms_px`` is that of the edge points about it, along their normals; ``unseen`` names
    the planes of the block whose place the image does not show."""

    corners: tuple[Corner, ...]
    edges: tuple[EdgePoints, ...]
    camera: Camera
    rms_px: float
    unseen: tuple[str, ...] = ()


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
            ``image-blurred``, ``object-not-found``, ``object-unclear``,
            ``object-does-not-match``, ``object-mirrored``, ``object-ambiguous``,
            ``object-cut-off``; all but the first as ``DetectionRefusal``, with the evidence.
    """
    grey, clipped = grey_picture(ambient)
    findings = picture_findings(ambient)
    lit = None if stripe is None or len(stripe.u) == 0 else stripe_mask(grey, stripe)
    tries: list[_Tried] = []
    declined: list[tuple[Camera, bool]] = []
    try:
        refusals.refuse_unusable(findings, clipped)
        hidden = clipped if lit is None else clipped | lit
        for longer_px, cleaning in _ATTEMPTS:
            small, ignore, scale = working_picture(grey, lit, longer_px)
            found = locate(small, ignore, block, cleaning)
            tried = _tried(grey, hidden, found, scale, block, declined)
            tries.append(tried)
            if tried.good and not _doubtful(tried) and tried is max(tries, key=_borne_out):
                _refuse_gainsaid(tried, tries[:-1], findings, block)
                return _detection(_the_one(tried, findings, block), block)
            if _sure(tried):
                break
        doubted = max(tries, key=_borne_out)
        if doubted.good:
            return _detection(_the_one(doubted, findings, block), block)
        refusals.refuse_bad_picture(findings, "the object was not found")
        raise _why_not(tries, findings, grey, block)
    except Refusal as refusal:
        best = max(tries, key=lambda one: one.shown_px, default=_Tried(_NOTHING, []))
        raise with_evidence(
            refusal, findings, clipped, best.found, best.measured, best.against
        ) from None


def _refuse_gainsaid(
    tried: "_Tried", before: list["_Tried"], findings: list[PictureFinding], block: Crenellated
) -> None:
    """Refuses a find where an earlier try drew about as much of the object and found another.

    Raises:
        Refusal: ``object-does-not-match``.
    """
    for one in before:
        as_much = one.shown_px > _AS_MUCH * tried.shown_px
        if one.nearest is not None and one.against is not None and one.against.definite and as_much:
            raise refusals.contradicted(block, one.against, findings, one.nearest.blur_px)


@dataclass(frozen=True)
class _Tried:
    """One attempt: the placings that the picture bears out, best first, or, where there are
    none, the one that it does most (``nearest``) and what speaks against it."""

    found: Search
    good: list[tuple[Located, Survey]]
    nearest: Survey | None = None
    against: Objection | None = None

    @property
    def measured(self) -> Survey | None:
        """The best placing, borne out or not."""
        return self.good[0][1] if self.good else self.nearest

    @property
    def shown_px(self) -> float:
        """Length, px, of its edges that the picture shows."""
        return _explained(self.measured) if self.measured is not None else 0.0


def _share_shown(tried: _Tried) -> float:
    """Share of the drawn edges' length that the picture shows, of the placing it shows most."""
    if tried.measured is None:
        return 0.0
    return tried.shown_px / max(float(tried.measured.at.length_px.sum()), 1e-9)


def _sure(tried: _Tried) -> bool:
    """Whether the nearest placing is an object very like the block; no other try tells more."""
    if tried.nearest is None or tried.against is None or not tried.against.edges:
        return False
    well_drawn = tried.found.found[0].support > _SURE
    return tried.against.definite and well_drawn and _share_shown(tried) > _MOST


def _tried(
    grey: Floats,
    hidden: NDArray[np.bool_],
    found: Search,
    scale: float,
    block: Crenellated,
    declined: list[tuple[Camera, bool]],
) -> _Tried:
    """Measures the likeliest placings but those ``declined`` before, to which it adds."""
    if not found.found or found.found[0].support < _LEAST_SUPPORT:
        return _Tried(found, [])
    best = found.found[0].support
    blur_px = edge_blur_px(grey)
    coarse_px, made_mm = max(3.0, 2.0 / scale), block.standard_uncertainty_mm
    masked, smooth = np.where(hidden, np.nan, grey), softened(grey, coarse_px)
    good: list[tuple[Located, Survey]] = []
    rejected: list[tuple[Survey, Objection]] = []
    for rival in found.found[:_RIVALS]:
        start = _enlarged(rival.camera, scale, grey.shape)
        known = [(measured.camera, one.mirrored) for one, measured in good]
        if rival.support < _RIVAL * best or _among(start, rival.mirrored, known, block, _SAME):
            continue
        form = wireframe(mirrored(block) if rival.mirrored else block)
        camera = pulled(smooth, form, start, coarse_px)
        # Several starts may lead to one placing; it is measured once.
        if camera is None or _among(camera, rival.mirrored, known, block, _SAME):
            continue
        if _among(camera, rival.mirrored, declined, block, _VERY_SAME):
            continue
        measured = survey(masked, form, camera, blur_px, made_mm)
        if measured is None:
            continue
        measured, against = acceptance.judged(masked, measured, made_mm)
        if against is not None:
            rejected.append((measured, against))
            declined.append((camera, rival.mirrored))
        elif not _among(measured.camera, rival.mirrored, known, block, _SAME):
            good.append((rival, measured))
    good.sort(key=lambda one: -_explained(one[1]))
    if good:
        enough = _MORE * _explained(good[0][1])
        return _Tried(found, [one for one in good if _explained(one[1]) >= enough])
    # What hardly looks like the block says nothing against it either.
    if best < acceptance.LEAST_SUPPORT:
        return _Tried(found, [])
    nearest = max(rejected, key=lambda one: _explained(one[0]), default=(None, None))
    return _Tried(found, [], *nearest)


def _borne_out(tried: _Tried) -> float:
    """Length, px, of the edges that show of a try's best good placing."""
    return _explained(tried.good[0][1]) if tried.good else 0.0


def _doubtful(tried: _Tried) -> bool:
    """Whether another look at the picture may tell better which way the object stands."""
    return tried.good[0][0].mirrored or _more_than_one_way(tried)


def _more_than_one_way(tried: _Tried) -> bool:
    """Whether another placing is as good, or the other way round one as well supported."""
    best = tried.good[0][0]
    other_way = [one.support for one in tried.found.found if one.mirrored != best.mirrored]
    return len(tried.good) > 1 or max(other_way, default=0.0) > _DOUBTFUL * best.support


def _the_one(tried: _Tried, findings: list[PictureFinding], block: Crenellated) -> Survey:
    """The measured placing, if there is no other and it is fit to be used.

    Raises:
        Refusal: ``image-blurred``, ``image-saturated``, ``object-ambiguous``,
            ``object-mirrored``, ``object-cut-off``.
    """
    located, measured = tried.good[0]
    refusals.refuse_blurred(measured)
    share = acceptance.in_frame(measured)
    if _more_than_one_way(tried) or acceptance.symmetric(block):
        refusals.refuse_bad_picture(findings, "it can be read in more than one way")
        raise refusals.ambiguous(block, share)
    if located.mirrored:
        raise refusals.mirror_refusal(block, share)
    if acceptance.too_little_left(measured, block, share):
        raise refusals.too_much_cut_off(block, share)
    return measured


def _why_not(
    tries: list[_Tried], findings: list[PictureFinding], grey: Floats, block: Crenellated
) -> Refusal:
    """The refusal after the last attempt: another object, or one not seen well enough."""
    best = max(tries, key=lambda one: one.shown_px)
    # Lines that mostly make no block are of marks and of other things: these may hide it.
    block_like = [acceptance.block_like(one.found) for one in tries]
    seen_well = not findings and not noisy(grey) and sum(block_like) > len(tries) / 2
    # A placing that hardly shows is none to say where the frame ends on.
    if best.nearest is not None and _share_shown(best) > acceptance.LEAST_SHOWN:
        share = acceptance.in_frame(best.nearest)
        if acceptance.too_little_left(best.nearest, block, share):
            return refusals.too_much_cut_off(block, share)
    if best.nearest is not None and best.against is not None and best.against.definite:
        return refusals.contradicted(block, best.against, findings, best.nearest.blur_px)
    if not any(block_like):
        return refusals.unfound(tries[0].found)
    why = "no placing of its edges explains those in the picture"
    if best.against is not None:
        why = best.against.text
    return refusals.mismatch(block, why) if seen_well else refusals.unclear(block, why)


def _explained(measured: Survey) -> float:
    """Length, px, of the edges that the picture shows where they are drawn."""
    return float(measured.at.length_px[measured.used].sum())


def _among(
    camera: Camera,
    reverse: bool,
    placings: list[tuple[Camera, bool]],
    block: Crenellated,
    share: float,
) -> bool:
    """Whether a placing draws the crests where another does, to a share of the longer side.

    A placing is a camera, and whether it shows the block mirrored.
    """
    points = np.array([at for name, at in corners_of(block).items() if name.startswith("crest")])
    for other, other_reverse in placings:
        if other_reverse != reverse:
            continue
        apart = project(camera, points) - project(other, points)
        if np.hypot(*apart.T).max() < share * max(camera.width_px, camera.height_px):
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
    found = corners_where_edges_meet(measured, block)
    if len(found) < _LEAST_CORNERS:
        raise refusals.unclear(block, f"only {len(found)} of its corners can be measured")
    return ObjectDetection(
        found,
        tuple(edges),
        measured.camera,
        float(np.sqrt(np.mean(off**2))),
        unseen(measured),
    )
