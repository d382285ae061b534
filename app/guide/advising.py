"""Works out which pose would help most after those taken."""

from collections.abc import Mapping

import numpy as np

from app.files.calibrate import joint_inputs
from app.files.session import read_session
from app.guide.advice import Advice
from app.guide.session_folder import SessionFolder
from app.metrology.adjustment.block_start import SeenPose
from app.metrology.adjustment.joint import JointCalibration, JointInputs, calibrate_joint
from app.metrology.adjustment.pose_advice import PoseAdvice, held, next_poses
from app.metrology.adjustment.state import pose_scene
from app.metrology.findings import Limits
from app.metrology.frames import Floats, inverse, rigid, vector_from_rotation
from app.metrology.refusal import Refusal

# Of advices that bring nearly as much, the one that asks for the least movement.
NEARLY = 1.06


def advise(
    folder: SessionFolder, known: Mapping[int, SeenPose | Refusal], limits: Limits
) -> Advice | None:
    """The pose that would help most after those taken; None where none is to be told.

    Raises:
        Refusal: no calibration follows from the poses so far.
    """
    session = read_session(folder.path)
    inputs = joint_inputs(session, limits, known=known)
    found = calibrate_joint(inputs)
    best = _chosen(found, inputs)
    if best is None:
        return None
    state = found.adjusted.state
    return Advice(
        poses=len(found.adjusted.problem.views),
        now_um=found.known.total_um,
        then_um=best.total_um,
        words=held(best.T_obj_cam, _newest(found), inputs.block).words,
        outline=[(*a, *b) for a, b in best.outline_px],
        q_rad=best.q_rad.tolist(),
        T_obj_cam=best.T_obj_cam.tolist(),
        T_arm_obj=state.T_arm_obj.tolist(),
        T_flange_cam=state.T_flange_cam.tolist(),
    )


def _chosen(found: JointCalibration, inputs: JointInputs) -> PoseAdvice | None:
    used = set(found.adjusted.problem.numbers)
    own = [i for i, pose in enumerate(inputs.seen) if pose.number in used]
    offered = next_poses(found.adjusted, inputs.arm, inputs.block, inputs.q_rad[own])
    if not offered:
        return None
    newest = _newest(found)
    good = [one for one in offered if one.total_um <= NEARLY * offered[0].total_um]
    return min(good, key=lambda one: _turned_rad(one.T_obj_cam, newest))


def _newest(found: JointCalibration) -> Floats:
    """``T_obj_cam`` (4, 4) of the pose that was taken last."""
    adjusted = found.adjusted
    last = len(adjusted.problem.views) - 1
    camera = pose_scene(adjusted.state, adjusted.problem, adjusted.layout, last).camera
    return inverse(rigid(camera.rotation, camera.translation_mm))


def _turned_rad(T_a: Floats, T_b: Floats) -> float:
    return float(np.linalg.norm(vector_from_rotation(T_a[:3, :3] @ T_b[:3, :3].T)))
