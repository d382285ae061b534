"""The attempts to find the block: each searches a reduced picture, measures the likeliest
hypotheses in the full one, and judges how well the picture supports them."""

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from crenel.metrology.detection import acceptance
from crenel.metrology.detection.edges.as_made import AS_MADE_MM, block_as_made, is_open
from crenel.metrology.detection.edges.measure_all import (
    EdgeMeasurements,
    align_camera_to_edges,
    measure_edges,
    smooth_for_search,
)
from crenel.metrology.detection.image_quality import edge_blur_px
from crenel.metrology.detection.rejection import RejectionReason
from crenel.metrology.detection.search.coarse_pose import CoarsePose, SearchResult
from crenel.metrology.detection.search.pose_hypotheses import mirror_block
from crenel.metrology.detection.visibility import wireframe
from crenel.metrology.sensor.camera import Camera, project
from crenel.metrology.targets.crenellated_block import Crenellated
from crenel.metrology.targets.crenellated_block import corners as corners_of
from crenel.metrology.transforms import Floats

# A hypothesis with this much less support than the best one is not a rival.
_RIVAL = 0.85
_RIVALS = 4
# Tool marks leave even the correct hypothesis little support; with less, it is not worth measuring.
_LEAST_SUPPORT = 0.15
# Hypotheses whose crests agree to this share of the picture's longer side are the same.
_SAME, _VERY_SAME = 0.01, 0.0005
# A mirrored hypothesis with this share of the best one's support makes the orientation doubtful.
_DOUBTFUL = 0.95
_SURE = 0.8
_MOST = 0.6
# A hypothesis that explains less than this share of what the best one does is not a rival either.
_MORE = 0.88
_USUAL_BLUR_PX = 1.5
# A block that the certificate leaves open is estimated so many times: the first estimate may be
# from edges that were hardly in reach.
_ESTIMATES = 2


@dataclass(frozen=True)
class CameraHypothesis:
    """A hypothesis: its camera for the full picture, and whether it shows the block mirrored.

    ``shown_px``: length of its edges that the picture shows, if it was measured.
    """

    camera: Camera
    mirrored: bool
    visible_px: float = np.inf


@dataclass(frozen=True)
class AttemptResult:
    """One attempt: the hypotheses that the picture supports, best first, or, if there are none, the
    one that it supports most (``nearest``) and the evidence against it.

    ``doubted``: whether the block may equally well have the opposite orientation.
    """

    search: SearchResult
    good: list[tuple[CoarsePose, EdgeMeasurements]]
    nearest: EdgeMeasurements | None = None
    against: RejectionReason | None = None
    mirror_doubt: bool = False

    @property
    def measured(self) -> EdgeMeasurements | None:
        """The best hypothesis, supported or not."""
        return self.good[0][1] if self.good else self.nearest

    @property
    def visible_px(self) -> float:
        """Length of its edges that the picture shows."""
        return _visible_length_px(self.measured) if self.measured is not None else 0.0

    @property
    def confirmed_px(self) -> float:
        """The same, if the picture supports a hypothesis."""
        return _visible_length_px(self.good[0][1]) if self.good else 0.0

    @property
    def visible_share(self) -> float:
        """Relative to the length of the predicted edges."""
        if self.measured is None:
            return 0.0
        return self.visible_px / max(float(self.measured.at.length_px.sum()), 1e-9)

    @property
    def is_other_object(self) -> bool:
        """Whether the nearest hypothesis is an object very similar to the block; no other attempt
        shows more."""
        if self.nearest is None or self.against is None or not self.against.edges:
            return False
        well_drawn = self.search.poses[0].support > _SURE
        return self.against.definite and well_drawn and self.visible_share > _MOST

    @property
    def is_ambiguous(self) -> bool:
        """Whether another hypothesis is equally good, or the opposite orientation may be."""
        return len(self.good) > 1 or self.mirror_doubt

    @property
    def doubtful(self) -> bool:
        """Whether another attempt may show the orientation of the block better."""
        return self.good[0][0].mirrored or self.is_ambiguous


NO_ATTEMPT = AttemptResult(SearchResult((), 0.0, np.empty((0, 4))), [])


def verify_hypotheses(
    grey: Floats,
    hidden: NDArray[np.bool_],
    found: SearchResult,
    scale: float,
    block: Crenellated,
    declined: list[CameraHypothesis],
) -> AttemptResult:
    """Measures the likeliest hypotheses except those ``declined`` before, to which it adds."""
    if not found.poses or found.poses[0].support < _LEAST_SUPPORT:
        return AttemptResult(found, [])
    best = found.poses[0].support
    looks = _HypothesisVerifier(grey, hidden, scale, block, declined)
    for rank, rival in enumerate(found.poses):
        # A later hypothesis may show the opposite orientation equally well.
        if rival.support >= (_RIVAL if rank < _RIVALS else _DOUBTFUL) * best:
            looks.verify(rival)
    good = sorted(looks.good, key=lambda one: -_visible_length_px(one[1]))
    if good:
        enough_px = _MORE * _visible_length_px(good[0][1])
        rivals = [one for one in good if _visible_length_px(one[1]) >= enough_px]
        return AttemptResult(
            found, rivals, mirror_doubt=looks.mirror_is_likely(good[0][0], enough_px)
        )
    # A hypothesis that hardly looks like the block is no evidence against it either.
    if best < acceptance.LEAST_SUPPORT:
        return AttemptResult(found, [])
    nearest = max(looks.rejected, key=lambda one: _visible_length_px(one[0]), default=(None, None))
    return AttemptResult(found, [], *nearest)


class _HypothesisVerifier:
    """The hypotheses of one attempt as the full picture shows them: ``good``, or ``rejected``."""

    def __init__(
        self,
        grey: Floats,
        hidden: NDArray[np.bool_],
        scale: float,
        block: Crenellated,
        declined: list[CameraHypothesis],
    ) -> None:
        self._coarse_px = max(3.0, 2.0 / scale)
        blur_px = edge_blur_px(grey)
        # If hardly an edge exceeds the noise, the blur is unknown; a start value is needed.
        self._blur_px = blur_px if np.isfinite(blur_px) else _USUAL_BLUR_PX
        self._masked = np.where(hidden, np.nan, grey)
        self._smooth = smooth_for_search(grey, self._coarse_px)
        self._block, self._declined = block, declined
        self._others: list[tuple[CoarsePose, float]] = []
        self.good: list[tuple[CoarsePose, EdgeMeasurements]] = []
        self.rejected: list[tuple[EdgeMeasurements, RejectionReason]] = []

    def verify(self, rival: CoarsePose) -> None:
        """Measures a hypothesis, unless it was measured before."""
        block, reverse = self._block, rival.mirrored
        known = [CameraHypothesis(found.camera, located.mirrored) for located, found in self.good]
        start = _scale_camera(rival.camera, self._masked.shape)
        if _find_same(start, reverse, known, block, _SAME):
            return
        form = wireframe(mirror_block(block) if reverse else block)
        camera = align_camera_to_edges(self._smooth, form, start, self._coarse_px)
        if camera is None:
            self._others.append((rival, np.inf))
            return
        # Several start values may lead to one hypothesis; it is measured once.
        before = _find_same(camera, reverse, self._declined, block, _VERY_SAME)
        if before is not None:
            self._others.append((rival, before.visible_px))
        if before is not None or _find_same(camera, reverse, known, block, _SAME):
            return
        measured, made_mm = self._measure(mirror_block(block) if reverse else block, camera)
        if measured is None:
            self._others.append((rival, np.inf))
            return
        if self.good and _visible_length_px(measured) < _MORE * self._most_visible_px():
            # Removing outliers only shortens it: it cannot become a rival.
            return
        measured, against = acceptance.check_measurements(self._masked, measured, made_mm)
        if against is not None:
            self.rejected.append((measured, against))
            self._declined.append(CameraHypothesis(camera, reverse, _visible_length_px(measured)))
            self._others.append((rival, _visible_length_px(measured)))
        elif not _find_same(measured.camera, reverse, known, block, _SAME):
            self.good.append((rival, measured))

    def _measure(self, block: Crenellated, camera: Camera) -> tuple[EdgeMeasurements | None, float]:
        """The edges in the full picture, and the standard uncertainty of the planes in which they
        are expected: those of the certificate, or as made where it leaves them open."""
        certified_mm = block.standard_uncertainty_mm
        form = wireframe(block)
        measured = measure_edges(self._masked, form, camera, self._blur_px, certified_mm)
        if measured is None or not is_open(measured, certified_mm):
            return measured, certified_mm
        as_made = measured
        for _ in range(_ESTIMATES):
            made = block_as_made(as_made, block)
            if made is None:
                return measured, certified_mm
            form, camera = wireframe(made), as_made.camera
            again = measure_edges(self._masked, form, camera, self._blur_px, AS_MADE_MM)
            if again is None:
                return measured, certified_mm
            as_made = again
        return as_made, AS_MADE_MM

    def _most_visible_px(self) -> float:
        return max(_visible_length_px(measured) for _, measured in self.good)

    def mirror_is_likely(self, best: CoarsePose, enough_px: float) -> bool:
        """Whether the opposite orientation is drawn about equally well, and the full picture does
        not show that it explains less: it could not be measured, or as much of it shows."""
        return any(
            one.mirrored != best.mirrored
            and one.support > _DOUBTFUL * best.support
            and shown_px >= enough_px
            for one, shown_px in self._others
        )


def _visible_length_px(measured: EdgeMeasurements) -> float:
    """Length, px, of the edges that the picture shows at their predicted positions."""
    return float(measured.at.length_px[measured.used].sum())


def _find_same(
    camera: Camera,
    reverse: bool,
    placings: list[CameraHypothesis],
    block: Crenellated,
    share: float,
) -> CameraHypothesis | None:
    """The hypothesis whose crests agree with those of another one, to a share of the longer
    side."""
    points = np.array([at for name, at in corners_of(block).items() if name.startswith("crest")])
    for other in placings:
        if other.mirrored != reverse:
            continue
        apart = project(camera, points) - project(other.camera, points)
        if np.hypot(*apart.T).max() < share * max(camera.width_px, camera.height_px):
            return other
    return None


def _scale_camera(camera: Camera, shape: tuple[int, ...]) -> Camera:
    """The camera of the small picture for the full one; pixels' centres are whole numbers."""
    height, width = shape[:2]
    K = camera.matrix.copy()
    across, down = width / camera.width_px, height / camera.height_px
    K[0] *= across
    K[1] *= down
    K[0, 2] += 0.5 * (across - 1)
    K[1, 2] += 0.5 * (down - 1)
    return replace(camera, matrix=K, width_px=width, height_px=height)
