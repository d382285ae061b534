"""The crenellated sample sessions as a competent user of OpenCV would calibrate them.

Corners clicked to a pixel and refined by cornerSubPix, calibrateCamera on all pictures,
solvePnP on each, the block's place by contacts (fitted as Crenel fits them) or the hand-eye
methods, and a plane of least squares through the stripe's points on crests and floors.
"""

from collections.abc import Iterator, Sequence
from pathlib import Path

import cv2
import numpy as np
from scipy.spatial.transform import Rotation

from crenel.formats.images import read_grey
from crenel.formats.session.calibration_session import BlockSession, read_session
from crenel.metrology.adjustment.block.calibrate import calibrate_block
from crenel.metrology.adjustment.block.problem import BlockInputs
from crenel.metrology.adjustment.core.observations import BlockObservation
from crenel.metrology.arm.kinematics import flange_poses, tip_centres
from crenel.metrology.calibration.laser_plane_fit import classify_levels
from crenel.metrology.probing.alignment import align
from crenel.metrology.targets.crenellated_block import corners
from crenel.metrology.transforms import Floats, apply, inverse, rigid
from crenel.workflows.calibrate import joint_inputs
from tests.bench.board_measures import (
    PeerCalibration,
    calibrate_camera,
    move_camera,
    plane_through,
    solve_pose,
)
from tests.bench.hand_eye import K1_ONLY, hand_eye_methods
from tests.bench.rows import Rows
from tests.bench.sessions import Calibrated, errors_um

SAMPLES = ("one-pose", "many-poses", "metal")
HALF_WINDOW_PX = 4
MIN_POSES = 3


def click_corners(seen: BlockObservation, session: BlockSession) -> tuple[Floats, Floats]:
    """The block's corners in one picture: where on the block (N, 3), and pixels (N, 2)."""
    at = corners(session.block)
    found = [corner for corner in seen.detection.corners if corner.name in at]
    clicks = np.round([[corner.u, corner.v] for corner in found]).astype(np.float32)
    (picture,) = (pose.ambient for pose in session.poses if pose.number == seen.number)
    window = (HALF_WINDOW_PX, HALF_WINDOW_PX)
    image, start = read_grey(picture), clicks.reshape(-1, 1, 2)
    uv = cv2.cornerSubPix(image, start, window, (-1, -1), (3, 50, 1e-4))
    return np.array([at[corner.name] for corner in found]), uv.reshape(-1, 2).astype(np.float64)


def calibrate_opencv(session: BlockSession, inputs: BlockInputs) -> Iterator[PeerCalibration]:
    size_px = (session.sensor.width_px, session.sensor.height_px)
    guess = np.array(
        [[size_px[0], 0, size_px[0] / 2], [0, size_px[0], size_px[1] / 2], [0, 0, 1.0]]
    )
    clicked = [click_corners(seen, session) for seen in inputs.observations]
    flags = K1_ONLY | cv2.CALIB_USE_INTRINSIC_GUESS
    camera = calibrate_camera(clicked, size_px, guess, flags)
    T_cam_obj = [solve_pose(camera, *points) for points in clicked]
    lines = []
    for seen, T in zip(inputs.observations, T_cam_obj, strict=True):
        level, points = classify_levels(move_camera(camera, T), session.block, seen.stripe.uv_px)
        lines.append(apply(T, points[level != ""]))
    plane = plane_through(np.concatenate(lines))
    nominal = np.array(list(corners(session.block).values()))
    T_arm_flange = list(flange_poses(session.arm, inputs.q_rad))
    for name, T_flange_cam in mountings(session, T_arm_flange, T_cam_obj):
        yield PeerCalibration(f"OpenCV, {name}", camera, T_flange_cam, nominal, plane)


def mountings(
    session: BlockSession, T_arm_flange: Sequence[Floats], T_cam_obj: Sequence[Floats]
) -> Iterator[tuple[str, Floats]]:
    contacts = session.contacts
    tips = tip_centres(session.arm, contacts.q_rad)
    T_arm_obj = align(contacts.features, tips, session.arm.tip.radius_mm, session.block).T_arm_obj
    each = np.array(
        [
            inverse(flange) @ T_arm_obj @ inverse(seen)
            for flange, seen in zip(T_arm_flange, T_cam_obj, strict=True)
        ]
    )
    yield "contacts, first pose", each[0]
    if len(each) < MIN_POSES:
        return
    turn = Rotation.from_matrix(each[:, :3, :3]).mean().as_matrix()
    yield "contacts, mean of poses", rigid(turn, each[:, :3, 3].mean(axis=0))
    yield from hand_eye_methods(T_arm_flange, T_cam_obj)


def measure_samples(samples: Path, rows: Rows) -> None:
    """A row for each sample session and way to calibrate."""
    for name in SAMPLES:
        session = read_session(samples / name)
        inputs = joint_inputs(session)
        calibrated: dict[str, Calibrated]
        calibrated = {solved.name: solved for solved in calibrate_opencv(session, inputs)}
        for method, found in (calibrated | {"Crenel": calibrate_block(inputs)}).items():
            inside, in_flange = errors_um(found, samples / name)
            rows.add(f"{name}: {method}", {"sensor, µm": inside, "flange, µm": in_flange})
