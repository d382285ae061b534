"""All observations linearised at one state: normal matrices by source."""

from dataclasses import dataclass

import numpy as np

from crenel.metrology.adjustment.core.observations import (
    AdjustmentProblem,
    ContactRows,
    contact_rows,
)
from crenel.metrology.adjustment.core.parameters import (
    CAMERA,
    LENS,
    PLACE,
    AdjustmentState,
    ParameterLayout,
    PoseScene,
    pose_scene,
)
from crenel.metrology.adjustment.core.robust_weights import RobustWeights, normal_equations
from crenel.metrology.adjustment.core.variance_components import Scales
from crenel.metrology.calibration.observation_model import BLOCK, Rows
from crenel.metrology.sensor.camera import Camera
from crenel.metrology.transforms import Floats

# Prior of any lens and sensor; it matters only if the pictures contain no information: pixels
# square to this share, axis off by this share of the width.
ASPECT_SD = 0.002
AXIS_SD_WIDTHS = 0.25
LENS_SD = np.array([0.5, 2.0, 0.01, 0.01])  # k1, k2, p1, p2

SOURCES = ("edges", "stripe", "contacts", "encoders", "links", "certificate", "camera")

# For each pose: the shape of the object, and the stripe.
PoseWeights = tuple[tuple[RobustWeights, RobustWeights], ...]


@dataclass(frozen=True)
class ContactEquations:
    """The rows of the contact points that count, by all unknowns."""

    residuals_mm: Floats  # (N,)
    jacobian: Floats  # (N, U)
    noise_mm2: Floats  # (N,) variance due to the encoders

    def variances(self, scales: Scales) -> Floats:
        """(N,) mm^2"""
        return np.asarray(scales.touch_mm**2 + scales.noise**2 * self.noise_mm2)


@dataclass(frozen=True)
class Linearisation:
    """Rows of all kinds at one state."""

    problem: AdjustmentProblem
    at: ParameterLayout
    state: AdjustmentState
    scenes: tuple[PoseScene, ...]
    rows: tuple[tuple[Rows, Rows], ...]  # shape and stripe of each pose
    contact_rows: ContactRows | None
    contacts: ContactEquations | None


@dataclass(frozen=True)
class NormalEquations:
    """``J' W J`` (U, U) by ``SOURCES`` and ``J' W r`` (U,); scales may still change."""

    linear: Linearisation
    image_parts: dict[str, Floats]
    gradient: Floats

    def with_scales(self, scales: Scales) -> tuple[dict[str, Floats], Floats]:
        """All parts, with contact points and priors weighted by the scales."""
        linear, at = self.linear, self.linear.at
        parts = {source: np.zeros((at.count, at.count)) for source in SOURCES} | self.image_parts
        g = self.gradient.copy()
        if linear.contacts is not None:
            _add_contacts(parts, g, linear.contacts, scales)
        for source, where, sd, off in prior_information(linear, scales):
            index = np.arange(at.count)[where]
            part = parts[source].copy()
            part[index, index] += sd**-2.0
            parts[source] = part
            g[index] += sd**-2.0 * off
        return parts, g


def linearise(
    problem: AdjustmentProblem, at: ParameterLayout, state: AdjustmentState
) -> Linearisation:
    """Residuals of all observations at one state, and their derivatives."""
    scenes = tuple(pose_scene(state, problem, at, p) for p in range(len(problem.views)))
    rows = tuple(
        view.rows(scene.camera, scene.plane, state.coordinates)
        for view, scene in zip(problem.views, scenes, strict=True)
    )
    touches = problem.contacts
    if touches is None:
        return Linearisation(problem, at, state, scenes, rows, None, None)
    touch_rows = contact_rows(touches, state.T_arm_obj, state.coordinates, state.links)
    J = np.zeros((len(touches), at.count))
    J[:, PLACE] = touch_rows.by_place
    J[:, at.links] = touch_rows.by_links
    J[:, at.coordinates] = touch_rows.by_coordinates
    kept = touches.inliers
    contacts = ContactEquations(touch_rows.residuals_mm[kept], J[kept], touch_rows.noise_mm2[kept])
    return Linearisation(problem, at, state, scenes, rows, touch_rows, contacts)


def assemble_normal_equations(linear: Linearisation, judgements: PoseWeights) -> NormalEquations:
    """The contribution of the pictures to the normal equations."""
    count = linear.at.count
    pictures = {source: np.zeros((count, count)) for source in ("edges", "stripe", "camera")}
    g = np.zeros(count)
    kinds = zip(linear.scenes, linear.rows, judgements, strict=True)
    for pose, (scene, groups, by_kind) in enumerate(kinds):
        for source, rows, judgement in zip(("edges", "stripe"), groups, by_kind, strict=True):
            N, pull = normal_equations(rows, judgement)
            _add_image(pictures[source], g, N, pull, scene, linear.at, pose)
    N, pull = camera_prior(linear.state.camera)
    pictures["camera"][CAMERA, CAMERA] += N
    g[CAMERA] += pull
    return NormalEquations(linear, pictures, g)


def _add_image(
    part: Floats,
    g: Floats,
    N: Floats,
    pull: Floats,
    scene: PoseScene,
    at: ParameterLayout,
    pose: int,
) -> None:
    """Adds the equations of one pose, in its own parameters, to part (U, U) and g (U,).

    The coordinates of the object are unknowns themselves; they depend on the noise of their own
    pose only.
    """
    own, coordinates = slice(0, BLOCK.start), slice(BLOCK.start, None)
    shared, noise = slice(0, at.noise.start), at.noise_slice(pose)
    by = np.hstack([scene.by_unknowns[own, shared], scene.by_unknowns[own, noise]])
    among, along = by.T @ N[own, own] @ by, by.T @ pull[own]
    across = N[coordinates, own] @ by
    part[at.coordinates, at.coordinates] += N[coordinates, coordinates]
    g[at.coordinates] += pull[coordinates]
    places = ((shared, shared), (noise, slice(at.noise.start, None)))
    for to, of in places:
        for other_to, other_of in places:
            part[to, other_to] += among[of, other_of]
        part[at.coordinates, to] += across[:, of]
        part[to, at.coordinates] += across[:, of].T
        g[to] += along[of]


def _add_contacts(
    parts: dict[str, Floats], g: Floats, contacts: ContactEquations, scales: Scales
) -> None:
    """The contribution of contact points, split into touch and encoder noise."""
    J, variance = contacts.jacobian, contacts.variances(scales)
    touch = np.full(len(variance), scales.touch_mm**2)
    for source, share in (("contacts", touch), ("encoders", variance - touch)):
        parts[source] = parts[source] + (J * (share / variance**2)[:, None]).T @ J
    g += J.T @ (contacts.residuals_mm / variance)


def prior_information(
    linear: Linearisation, scales: Scales
) -> list[tuple[str, slice, Floats, Floats]]:
    """Source, unknowns, standard deviations and deviations of the priors: the certificate, the
    errors of the arm's links, the noise of its readings."""
    problem, at, state = linear.problem, linear.at, linear.state
    prior, count = problem.prior, len(problem.views)
    noise_sd = np.tile(scales.noise * problem.motion.noise_sd, count)
    return [
        ("certificate", at.coordinates, prior.sd, state.coordinates - prior.coordinates),
        ("links", at.links, scales.link_error_sds(len(state.links) // 6), state.links),
        ("encoders", at.noise, noise_sd, state.noise.ravel()),
    ]


def camera_prior(camera: Camera) -> tuple[Floats, Floats]:
    """Prior of the camera: square pixels, an axis near the middle, little distortion; matrix (8, 8)
    and gradient (8,)."""
    N, g = np.zeros((8, 8)), np.zeros(8)
    K = camera.matrix
    aspect = np.zeros(8)
    aspect[0], aspect[1] = -K[1, 1] / K[0, 0] ** 2, 1 / K[0, 0]
    N += np.outer(aspect, aspect) / ASPECT_SD**2
    g += aspect * (K[1, 1] / K[0, 0] - 1) / ASPECT_SD**2
    middle = (np.array([camera.width_px, camera.height_px]) - 1) / 2
    axis_weight = (AXIS_SD_WIDTHS * camera.width_px) ** -2.0
    N[[2, 3], [2, 3]] += axis_weight
    g[2:4] += axis_weight * (K[:2, 2] - middle)
    lens = np.arange(LENS.start, LENS.stop)
    N[lens, lens] += LENS_SD**-2.0
    g[lens] += camera.distortion[:4] * LENS_SD**-2.0
    return N, g
