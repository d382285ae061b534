"""Where the block stands, from straight segments whose directions are known."""

import numpy as np
import pytest

from crenel.metrology.detection.search.line_segments import Segments
from crenel.metrology.detection.search.pose_hypotheses import pose_hypotheses
from crenel.metrology.detection.search.vanishing_points import Directions
from crenel.metrology.detection.visibility import visible_parts
from crenel.metrology.sensor.camera import Camera, project
from crenel.metrology.targets.crenellated_block import Crenellated
from crenel.metrology.transforms import rotation_from_vector
from tests.metrology.numerics import unit

EDGES_MM = (-22.0, -15.0, -9.0, 0.0, 4.0, 13.0, 19.0, 24.0)
BLOCK = Crenellated("Block", "1", EDGES_MM, -9.0, 14.0, 11.0, 0.0, -8.0, 0.002)
WIDTH, HEIGHT, FOCAL = 1280, 1024, 4200.0


def standing() -> Camera:
    """A camera with a long lens, far away, left of the block, before it and above it."""
    eye = np.array([-110.0, -190.0, 160.0])
    ahead = unit(-eye)
    right = unit(np.cross(ahead, [0.0, 0.0, 1.0]))
    rotation = np.stack([right, np.cross(ahead, right), ahead])
    K = np.array([[FOCAL, 0, (WIDTH - 1) / 2], [0, FOCAL, (HEIGHT - 1) / 2], [0, 0, 1.0]])
    return Camera(K, rotation, -rotation @ eye, WIDTH, HEIGHT)


def seen(camera: Camera, axes: str) -> tuple[Segments, np.ndarray]:
    """The visible edges along some axes as segments, and the axis (S,) of each."""
    lines, family = [], []
    for part in visible_parts(BLOCK, camera.centre_mm):
        axis = int(np.argmax(np.abs(part.end_mm - part.start_mm)))
        ends = project(camera, np.array([part.start_mm, part.end_mm]))
        ends = (ends - [(WIDTH - 1) / 2, (HEIGHT - 1) / 2]) / WIDTH
        if "xyz"[axis] in axes and np.hypot(*(ends[1] - ends[0])) > 0.02:
            lines.append(ends.ravel())
            family.append(axis)
    length = np.hypot(*(np.array(lines)[:, 2:] - np.array(lines)[:, :2]).T)
    return Segments(np.array(lines), length), np.array(family)


@pytest.mark.parametrize("axes", ["xyz", "yz", "xy"])
def test_the_block_is_placed_though_a_direction_does_not_show(axes: str) -> None:
    camera = standing()
    segments, family = seen(camera, axes)
    # Directions as the picture gives them: half a degree off.
    off = rotation_from_vector(np.array([0.005, -0.006, 0.004]))
    directions = Directions(off @ camera.rotation, FOCAL / WIDTH, family, 1.0)
    found = pose_hypotheses(directions, segments, BLOCK)
    best = found[0]
    assert not best.mirrored
    assert np.linalg.norm(best.centre_mm - camera.centre_mm) < 8.0
    # Of 266 mm; and the block's middle is drawn where it is.
    middle = np.array([1.0, 2.5, 1.5])
    drawn = best.rotation @ (middle - best.centre_mm)
    drawn = drawn[:2] / drawn[2] * best.focal
    true = (project(camera, middle[None])[0] - [(WIDTH - 1) / 2, (HEIGHT - 1) / 2]) / WIDTH
    assert np.hypot(*(drawn - true)) < 0.01


def test_far_fewer_votes_than_the_best_are_of_no_interest() -> None:
    camera = standing()
    segments, family = seen(camera, "xyz")
    directions = Directions(camera.rotation, FOCAL / WIDTH, family, 1.0)
    votes = pose_hypotheses(directions, segments, BLOCK)[0].votes
    assert pose_hypotheses(directions, segments, BLOCK, best=3 * votes) == []
