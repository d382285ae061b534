"""The crenellated sample sessions as a competent user of OpenCV would calibrate them.

Corners clicked to a pixel and refined by cornerSubPix, calibrateCamera on all pictures,
solvePnP on each, the block's place by contacts (fitted as Crenel fits them) or the hand-eye
methods, and a plane of least squares through the stripe's points on crests and floors.
"""

import json
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

import cv2
import numpy as np
from scipy.spatial.transform import Rotation

from app.formats.images import read_grey
from app.formats.session.calibration_session import BlockSession, read_session
from app.metrology.adjustment.block.calibrate import calibrate_block
from app.metrology.adjustment.core.observations import BlockObservation
from app.metrology.arm.kinematics import flange_poses, tip_centres
from app.metrology.calibration.laser_plane_fit import classify_levels
from app.metrology.image import Image
from app.metrology.probing.alignment import align
from app.metrology.sensor.camera import Camera
from app.metrology.sensor.triangulation import sensor_points
from app.metrology.targets.crenellated_block import corners
from app.metrology.transforms import Floats, apply, inverse, rigid, rigid_fit
from app.workflows.calibrate import joint_inputs
from tests.bench.board_measures import PeerCalibration, move_camera, plane_through, solve_pose
from tests.bench.hand_eye import K1_ONLY, hand_eye_methods
from tests.bench.rows import Rows

SAMPLES = ("one-pose", "many-poses", "metal")
HALF_WINDOW_PX = 4
MIN_POSES = 3


@dataclass(frozen=True)
class ClickedCorners:
    """The block's corners in one picture: where on the block (N, 3), and pixels (N, 2)."""

    detection: BlockObservation
    T_arm_flange: Floats
    points_mm: Floats
    uv_px: Floats


def click_corners(
    image: Image, seen: BlockObservation, session: BlockSession, T_arm_flange: Floats
) -> ClickedCorners:
    at = corners(session.block)
    found = [corner for corner in seen.detection.corners if corner.name in at]
    clicks = np.round([[corner.u, corner.v] for corner in found]).astype(np.float32)
    window = (HALF_WINDOW_PX, HALF_WINDOW_PX)
    uv = cv2.cornerSubPix(image, clicks.reshape(-1, 1, 2), window, (-1, -1), (3, 50, 1e-4))
    points = np.array([at[corner.name] for corner in found])
    return ClickedCorners(seen, T_arm_flange, points, np.asarray(uv, np.float64).reshape(-1, 2))


def calibrate_opencv(
    session: BlockSession, views: Sequence[ClickedCorners]
) -> Iterator[PeerCalibration]:
    size_px = (session.sensor.width_px, session.sensor.height_px)
    guess = np.array(
        [[size_px[0], 0, size_px[0] / 2], [0, size_px[0], size_px[1] / 2], [0, 0, 1.0]]
    )
    _, K, distortion, _, _ = cv2.calibrateCamera(
        [view.points_mm.astype(np.float32) for view in views],
        [view.uv_px.astype(np.float32) for view in views],
        size_px,
        guess,
        np.zeros(5),
        flags=K1_ONLY | cv2.CALIB_USE_INTRINSIC_GUESS,
    )
    lens = np.ravel(distortion)[:5].astype(np.float64)
    camera = Camera(np.asarray(K, np.float64), np.eye(3), np.zeros(3), *size_px, lens)
    T_cam_obj = [solve_pose(camera, view.points_mm, view.uv_px) for view in views]
    T_arm_flange = [view.T_arm_flange for view in views]
    lines = []
    for view, T in zip(views, T_cam_obj, strict=True):
        level, points = classify_levels(
            move_camera(camera, T), session.block, view.detection.stripe.uv_px
        )
        lines.append(apply(T, points[level != ""]))
    plane = plane_through(np.concatenate(lines))
    nominal = np.array(list(corners(session.block).values()))
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


def errors_um(solved: PeerCalibration, folder: Path) -> tuple[float, float]:
    """Rms of the truth's points rebuilt: after one rigid fit, and in the flange's frame."""
    truth = json.loads((folder / "truth.json").read_text())
    rebuilt = sensor_points(solved.camera, solved.plane, np.array(truth["pixels"]))
    true = np.array(truth["points_sensor_frame_mm"])
    inside = apply(rigid_fit(true, rebuilt), rebuilt) - true
    in_flange = apply(solved.T_flange_sensor, rebuilt) - np.array(truth["points_flange_frame_mm"])
    return _rms_um(inside), _rms_um(in_flange)


def _rms_um(off_mm: Floats) -> float:
    return 1e3 * float(np.sqrt(np.mean(np.sum(off_mm**2, axis=1))))


def measure_samples(samples: Path, rows: Rows) -> None:
    """A row for each sample session and way to calibrate."""
    for name in SAMPLES:
        session = read_session(samples / name)
        inputs = joint_inputs(session)
        pictures = {pose.number: pose.ambient for pose in session.poses}
        views = [
            click_corners(read_grey(pictures[seen.number]), seen, session, T)
            for seen, T in zip(
                inputs.observations, flange_poses(session.arm, inputs.q_rad), strict=True
            )
        ]
        found = calibrate_block(inputs)
        nominal = np.array(list(corners(session.block).values()))
        crenel = PeerCalibration(
            "Crenel", found.camera, found.T_flange_sensor, nominal, found.plane
        )
        for solved in (*calibrate_opencv(session, views), crenel):
            inside, in_flange = errors_um(solved, samples / name)
            rows.add(f"{name}: {solved.name}", {"sensor, µm": inside, "flange, µm": in_flange})
