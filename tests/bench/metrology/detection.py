"""How surely the object is found: pictures with everything that may spoil them, and their truth.

The pictures come from the simulated station, a ray tracer that shares no code with what is
measured here. Each is searched with the block's certificate, and with one that is wrong.
"""

import time
from collections import Counter
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

import numpy as np

from crenel.errors import OperationError
from crenel.metrology.detection.detect_block import ObjectDetection, detect_object
from crenel.metrology.detection.visibility import visible_parts
from crenel.metrology.stripe import extract_stripe
from crenel.metrology.targets.crenellated_block import Crenellated
from crenel.metrology.targets.crenellated_block import corners as corners_of
from crenel.metrology.transforms import Floats
from crenel_hardware.simulator.rendering.degradations import (
    CERTIFICATE_SD_MM,
    NUISANCES,
    DegradedImage,
    draw_degraded_image,
    draw_workshop_block,
)
from crenel_hardware.simulator.scene.camera import to_pixels
from crenel_hardware.simulator.scene.world import CrenellatedBlock

# A corner is right within a pixel, or within this many of its own standard deviations;
CORNER_PX, CORNER_SIGMAS = 1.0, 5.0
# so are all corners of a picture together, root mean square, within these.
RMS_PX, RMS_SIGMAS = 0.3, 1.5
# What a lens model leaves of the truth, beside each corner's own deviation.
MODEL_PX = 0.02
# A wrong measure can be identified where it moves an edge that shows by so many pixels.
VISIBLE_SHIFT_PX = 2.0
# Sizes beside the merlons': what they are called, their fields, axes and planes along these.
_OTHER_SIZES = (
    ("front", "front_y_mm", 1, 0),
    ("back", "back_y_mm", 1, 1),
    ("crest", "crest_z_mm", 2, 2),
    ("base", "base_z_mm", 2, 0),
)
# The size of picture that times are stated for.
TIMED_PX = 1280 * 1024

Progress = Callable[[int, int], None]


@dataclass(frozen=True)
class SearchOutcome:
    """What one search gave. ``outcome``: ``right``, ``wrong``, or a refusal's code."""

    seed: int
    nuisances: frozenset[str]
    outcome: str
    why: str
    corners: int
    rms_px: float
    normalised: float
    """Rms of the corners' errors over their standard deviations."""
    seconds: float
    pixels: int


@dataclass(frozen=True)
class WrongCertificateOutcome:
    """A search with a certificate that is wrong by ``moved_px`` in this picture.

    ``named``: accepted, but what is wrong is named as not shown by the picture.
    """

    seed: int
    kind: str
    shift_px: float
    accepted: bool
    named: bool = False

    @property
    def wrongly_accepted(self) -> bool:
        """Whether it is accepted though the picture shows it to be wrong."""
        return self.accepted and self.shift_px >= VISIBLE_SHIFT_PX


@dataclass(frozen=True)
class DetectionBench:
    """The outcome of a benchmark: ``lines()`` is the table to print."""

    searches: Sequence[SearchOutcome]
    wrong_certificates: Sequence[WrongCertificateOutcome]

    @property
    def right(self) -> int:
        return sum(one.outcome == "right" for one in self.searches)

    @property
    def wrong(self) -> int:
        return sum(one.outcome == "wrong" for one in self.searches)

    @property
    def wrongly_accepted(self) -> int:
        """Wrong certificates that were accepted though the picture shows them to be wrong."""
        return sum(one.wrongly_accepted for one in self.wrong_certificates)

    def figures(self) -> dict[str, float | None]:
        """Of all pictures together; None for the corners where no detection was right."""
        right = [s for s in self.searches if s.outcome == "right"]
        return {
            "right": self.right,
            "refused": len(self.searches) - self.right - self.wrong,
            "wrong": self.wrong,
            "rms_px": float(np.median([s.rms_px for s in right])) if right else None,
            "normalised": float(np.median([s.normalised for s in right])) if right else None,
            "wrongly_accepted": self.wrongly_accepted,
        }

    def lines(self) -> list[str]:
        """The figures as lines of text."""
        found = [f"{'with':16}{'images':>8}{'right':>8}{'refused':>9}{'wrong':>7}"]
        for name in NUISANCES:
            found.append(self._row(name, [s for s in self.searches if name in s.nuisances]))
        found.append(self._row("all", self.searches))
        refused = Counter(s.outcome for s in self.searches if s.outcome not in ("right", "wrong"))
        found += [f"refused as {code}: {count}" for code, count in refused.most_common()]
        right = [s for s in self.searches if s.outcome == "right"]
        if right:
            rms, worst = np.percentile([s.rms_px for s in right], (50, 100))
            found.append(f"corners: rms {rms:.3f} px in the median picture, {worst:.3f} at most")
            low, middle, high = np.percentile([s.normalised for s in right], (5, 50, 95))
            found.append(
                f"error over predicted deviation: {middle:.2f} median,"
                f" {low:.2f} to {high:.2f} in nine pictures of ten"
            )
        seconds = [s.seconds for s in self.searches]
        plain = [s.seconds for s in self.searches if s.pixels == TIMED_PX]
        if plain:
            found.append(f"time: {np.median(plain):.2f} s for 1280 x 1024, median")
        if seconds:
            found.append(f"time: {np.mean(seconds):.2f} s mean, {max(seconds):.2f} s at most")
        visible = [d for d in self.wrong_certificates if d.shift_px >= VISIBLE_SHIFT_PX]
        named = sum(d.wrongly_accepted and d.named for d in visible)
        hidden = [d for d in self.wrong_certificates if d.shift_px < VISIBLE_SHIFT_PX]
        found.append(
            f"wrong certificates: {len(visible)} that the picture shows to be wrong,"
            f" {self.wrongly_accepted} accepted ({named} of them with the remark that the picture"
            f" hides what is wrong); {len(hidden)} that it does not show,"
            f" {sum(d.accepted for d in hidden)} accepted"
        )
        return [*found, f"right: {self.right} of {len(self.searches)}, wrong: {self.wrong}"]

    @staticmethod
    def _row(name: str, group: Sequence[SearchOutcome]) -> str:
        right = sum(one.outcome == "right" for one in group)
        wrong = sum(one.outcome == "wrong" for one in group)
        share = f"{100 * right / len(group):.1f} %" if group else "-"
        return f"{name:16}{len(group):8}{share:>8}{len(group) - right - wrong:9}{wrong:7}"


def run(images: int, seed: int, progress: Progress | None = None) -> DetectionBench:
    """Searches so many pictures, and each once more with a wrong certificate.

    Args:
        images: how many; seed: of the first, the others follow.
        progress: called with the pictures done and their number.
    """
    searched, deceived = [], []
    for number in range(images):
        shot = draw_degraded_image(seed + number)
        searched.append(search_image(shot, seed + number))
        deceived.append(search_wrong_certificate(shot, seed + number))
        if progress is not None:
            progress(number + 1, images)
    return DetectionBench(searched, deceived)


def block_certificate(comb: CrenellatedBlock) -> Crenellated:
    """The certificate of a simulated block."""
    return Crenellated(
        "Simulated block",
        "TWIN",
        comb.edges_x_mm,
        comb.front_y_mm,
        comb.back_y_mm,
        comb.crest_z_mm,
        comb.floor_z_mm,
        comb.base_z_mm,
        CERTIFICATE_SD_MM,
    )


def detect_block(shot: DegradedImage, block: Crenellated) -> ObjectDetection:
    """The detection in a shot, its stripe left out where the laser is on.

    Raises:
        OperationError: as ``detect_object``.
    """
    rolled = abs(shot.optics.T_cam_sensor[0, 0]) < abs(shot.optics.T_cam_sensor[1, 0])
    stripe = extract_stripe(shot.image, "v" if rolled else "u") if shot.laser_on else None
    return detect_object(shot.image, block, stripe)


def search_image(shot: DegradedImage, seed: int) -> SearchOutcome:
    """Searches a shot with the block's own certificate and judges the answer."""
    began = time.process_time()
    outcome, why, count, rms, normalised = "right", "", 0, 0.0, 0.0
    try:
        found = detect_block(shot, block_certificate(shot.certificate))
    except OperationError as refusal:
        outcome, why = refusal.code, refusal.line
        seconds = time.process_time() - began
    else:
        seconds = time.process_time() - began
        errors, sigmas = corner_errors(found, shot)
        far = np.hypot(*errors.T)
        count, rms = len(errors), float(np.sqrt(np.mean(far**2))) if len(errors) else 0.0
        normalised = float(np.sqrt(np.mean(sigmas**2) / 2)) if len(errors) else 0.0
        wrong = (far > CORNER_PX) & (sigmas > CORNER_SIGMAS)
        together = rms <= RMS_PX or normalised <= RMS_SIGMAS
        if wrong.any() or not together or count == 0:
            worst = int(np.argmax(far)) if count else -1
            outcome = "wrong"
            why = (
                f"{found.corners[worst].name} is {far[worst]:.2f} px off" if count else "no corner"
            )
    return SearchOutcome(
        seed, shot.nuisances, outcome, why, count, rms, normalised, seconds, shot.image.size
    )


def corner_errors(found: ObjectDetection, shot: DegradedImage) -> tuple[Floats, Floats]:
    """Errors (N, 2) of the corners in px, and (N,) their lengths in standard deviations."""
    true = corners_of(block_certificate(shot.true_block))
    at = to_pixels(shot.optics, np.array([true[corner.name] for corner in found.corners]))
    errors = np.array([[corner.u, corner.v] for corner in found.corners]) - at
    own = np.array([corner.covariance_px2 for corner in found.corners])
    own = own + MODEL_PX**2 * np.eye(2)
    squares = np.einsum("ni,nij,nj->n", errors, np.linalg.inv(own), errors)
    return errors, np.sqrt(squares)


def search_wrong_certificate(shot: DegradedImage, seed: int) -> WrongCertificateOutcome:
    """Searches a shot with a wrong certificate: another block's, one size off, or mirrored."""
    rng = np.random.default_rng((seed, 4))
    kind = str(rng.choice(["other", "size", "size", "mirrored"]))
    claimed, wrong = block_certificate(shot.certificate), None
    if kind == "other":
        claimed = block_certificate(draw_workshop_block(rng))
    elif kind == "mirrored":
        claimed = replace(claimed, edges_x_mm=tuple(-x for x in reversed(claimed.edges_x_mm)))
    else:
        claimed, kind, wrong = _change_one_size(claimed, rng)
    moved = np.inf if wrong is None else _edge_shift_px(shot, claimed)
    try:
        found = detect_block(shot, claimed)
    except OperationError:
        return WrongCertificateOutcome(seed, kind, moved, False)
    return WrongCertificateOutcome(seed, kind, moved, True, wrong in found.unobserved_planes)


def _change_one_size(
    block: Crenellated, rng: np.random.Generator
) -> tuple[Crenellated, str, tuple[int, int]]:
    """The certificate with one size off by 0.3 to 2 mm, which, and what of the block that is."""
    by = float(rng.choice([-1.0, 1.0]) * rng.uniform(0.3, 2.0))
    count = len(block.edges_x_mm)
    which = int(rng.integers(count + len(_OTHER_SIZES)))
    if which < count:
        edges = list(block.edges_x_mm)
        edges[which] += by
        wrong = replace(block, edges_x_mm=tuple(edges))
        return wrong, f"edge {which} by {by:+.2f} mm", (0, which)
    name, field, axis, number = _OTHER_SIZES[which - count]
    wrong = replace(block, **{field: getattr(block, field) + by})
    return wrong, f"{name} by {by:+.2f} mm", (axis, number)


def _edge_shift_px(shot: DegradedImage, claimed: Crenellated) -> float:
    """By how many pixels, at most, a wrong certificate moves the edges that are in the picture.

    Across the edges, as the true camera sees them.
    """
    true, false = corners_of(block_certificate(shot.certificate)), corners_of(claimed)
    names, points = tuple(true), np.array(list(true.values()))
    size = [shot.optics.width_px, shot.optics.height_px]
    moved = 0.0
    for part in visible_parts(block_certificate(shot.certificate), shot.optics.centre_mm):
        pixels = to_pixels(shot.optics, np.array([part.start_mm, part.end_mm]))
        length = float(np.hypot(*(pixels[1] - pixels[0])))
        if length < 1.0:
            continue
        across = np.array([pixels[0, 1] - pixels[1, 1], pixels[1, 0] - pixels[0, 0]]) / length
        for point, uv in ((part.start_mm, pixels[0]), (part.end_mm, pixels[1])):
            apart = np.abs(points - point).max(axis=1)
            if apart.min() > 1e-6 or not np.all((uv >= 0) & (uv < size)):
                continue
            at = to_pixels(shot.optics, false[names[int(np.argmin(apart))]][None])[0]
            moved = max(moved, abs(float((at - uv) @ across)))
    return moved
