"""The tries at finding the block: one search of a small picture each, the likeliest placings
measured in the full one, and how far the picture bears them out."""

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from app.metrology.camera import Camera, project
from app.metrology.crenellated import Crenellated
from app.metrology.crenellated import corners as corners_of
from app.metrology.detection import acceptance
from app.metrology.detection.edge_survey import Survey, pulled, softened, survey
from app.metrology.detection.identify import mirrored
from app.metrology.detection.locate import Located, Search
from app.metrology.detection.objection import Objection
from app.metrology.detection.picture import edge_blur_px
from app.metrology.detection.visibility import wireframe
from app.metrology.frames import Floats

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
# Nor is one that explains less than this share of what the best does.
_MORE = 0.88


@dataclass(frozen=True)
class Tried:
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
        """Length of its edges that the picture shows."""
        return _shown_px(self.measured) if self.measured is not None else 0.0

    @property
    def borne_out_px(self) -> float:
        """The same, where the picture bears a placing out."""
        return _shown_px(self.good[0][1]) if self.good else 0.0

    @property
    def share_shown(self) -> float:
        """Of the length of the edges drawn."""
        if self.measured is None:
            return 0.0
        return self.shown_px / max(float(self.measured.at.length_px.sum()), 1e-9)

    @property
    def sure_of_another(self) -> bool:
        """Whether the nearest placing is an object very like the block; no other try tells more."""
        if self.nearest is None or self.against is None or not self.against.edges:
            return False
        well_drawn = self.found.found[0].support > _SURE
        return self.against.definite and well_drawn and self.share_shown > _MOST

    @property
    def more_than_one_way(self) -> bool:
        """Whether another placing is as good, or the other way round one as well supported."""
        best = self.good[0][0]
        other_way = [one.support for one in self.found.found if one.mirrored != best.mirrored]
        return len(self.good) > 1 or max(other_way, default=0.0) > _DOUBTFUL * best.support

    @property
    def doubtful(self) -> bool:
        """Whether another look at the picture may tell better which way the block stands."""
        return self.good[0][0].mirrored or self.more_than_one_way


NOT_TRIED = Tried(Search((), 0.0, np.empty((0, 4))), [])


def try_placings(
    grey: Floats,
    hidden: NDArray[np.bool_],
    found: Search,
    scale: float,
    block: Crenellated,
    declined: list[tuple[Camera, bool]],
) -> Tried:
    """Measures the likeliest placings but those ``declined`` before, to which it adds."""
    if not found.found or found.found[0].support < _LEAST_SUPPORT:
        return Tried(found, [])
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
    good.sort(key=lambda one: -_shown_px(one[1]))
    if good:
        enough = _MORE * _shown_px(good[0][1])
        return Tried(found, [one for one in good if _shown_px(one[1]) >= enough])
    # What hardly looks like the block says nothing against it either.
    if best < acceptance.LEAST_SUPPORT:
        return Tried(found, [])
    nearest = max(rejected, key=lambda one: _shown_px(one[0]), default=(None, None))
    return Tried(found, [], *nearest)


def _shown_px(measured: Survey) -> float:
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
