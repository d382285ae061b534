"""Poses from which a best fit may begin: the principal axes of scan and mesh, in every order."""

import numpy as np

from crenel.metrology.transforms import Floats, apply, rigid, rigid_fit
from crenel.parts.cad.maths_closest import MeshTree
from crenel.parts.cad.maths_smooth import SmoothSurface
from crenel.parts.maths.rough_alignment import principal_axes, turns_between

SAMPLES, FEW = 1500, 200
ROUNDS, TRIMMED = 8, 0.8
KEPT = 4
"""So many of the starts are refined."""


def start_poses(tree: MeshTree, surface: SmoothSurface, points_mm: Floats) -> list[Floats]:
    """``T_part_arm`` (4, 4) of a few likely poses, the best first.

    The pose in which the points are given is among those tried: they may be in the part's frame.
    """
    rng = np.random.default_rng(0)
    some = points_mm[rng.choice(len(points_mm), min(SAMPLES, len(points_mm)), replace=False)]
    places = _sample_surface(tree, rng)
    tried = [np.eye(4)]
    (axes, (middle, _)), (own, (centre, _)) = principal_axes(places), principal_axes(some)
    tried += [rigid(turn, middle - turn @ centre) for turn in turns_between(own, axes)]
    few = some[:FEW]
    ranked = sorted((_settle(tree, few, T) for T in tried), key=lambda one: one[0])
    return [T for _, T in ranked[:KEPT]]


def _settle(tree: MeshTree, points_mm: Floats, T: Floats) -> tuple[float, Floats]:
    """Median distance and pose after some rounds from closest point to closest point."""
    for _ in range(ROUNDS):
        moved = apply(T, points_mm)
        closest = tree.closest(moved)
        off = np.abs(closest.distance_mm)
        kept = off <= np.quantile(off, TRIMMED)
        T = rigid_fit(closest.at_mm[kept], points_mm[kept])
    off = np.abs(tree.closest(apply(T, points_mm)).distance_mm)
    return float(np.median(off)), T


def _sample_surface(tree: MeshTree, rng: np.random.Generator) -> Floats:
    """(N, 3) spread evenly over the mesh."""
    mesh = tree.mesh
    shares = mesh.areas_mm2 / mesh.areas_mm2.sum()
    faces = rng.choice(len(shares), SAMPLES, p=shares)
    corner = rng.dirichlet(np.ones(3), SAMPLES)
    return np.asarray(np.einsum("nc,nci->ni", corner, mesh.corners_mm[faces]))
