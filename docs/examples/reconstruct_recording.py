"""Reconstructs a recording into a cloud, as ``crenel reconstruct`` does.

The simulator provides a calibration session and a scan of a gauge sphere with the same sensor.
"""

import tempfile
from pathlib import Path

import numpy as np

from crenel import (
    Arm,
    RecordingWriter,
    calibrate_session,
    fit_sphere,
    read_any_arm,
    read_calibration,
    read_cloud,
    reconstruct_cloud,
)
from crenel_hardware.simulator.devices.kinematics import translation
from crenel_hardware.simulator.scene.world import GaugeSphere
from crenel_hardware.simulator.session import SessionPlan, draw_rig, render_scan, render_session

FRAME_NS = 40_000_000


def record_scan(path: Path, arm: Arm, seed: int, plan: SessionPlan) -> GaugeSphere:
    """A recording of images and joint angles, as the station writes it while scanning."""
    rig, sphere = draw_rig(seed, plan), GaugeSphere(radius_mm=12.7)
    sensor_path = [rig.T_arm_obj @ translation(0.0, y, 9.0) for y in np.linspace(-10, 10, 41)]
    with RecordingWriter(path, [joint.name for joint in arm.joints]) as recording:
        frames = render_scan(rig, sphere, rig.T_arm_obj, sensor_path, plan)
        for number, frame in enumerate(frames, start=1):
            recording.joints(number * FRAME_NS, frame.joints_rad)
            recording.image(number * FRAME_NS, frame.image)  # the stamp of its mid-exposure
    return sphere


def main(folder: Path) -> None:
    seed, plan = 3, SessionPlan(poses=1, width_px=640, height_px=512)
    render_session(folder / "session", seed, plan)
    calibrate_session(folder / "session", folder / "calibration.json", method="one-pose")
    arm = read_any_arm(folder / "session" / "arm.json")
    assert isinstance(arm, Arm)  # of joints; a robot that states poses is a RobotArm
    sphere = record_scan(folder / "scan.mcap", arm, seed, plan)

    # From here on: what any program does with a recording, a calibration and an arm.
    calibration = read_calibration(folder / "calibration.json")
    cloud_path = folder / "cloud.ply"  # .pcd and .xyz work alike
    result = reconstruct_cloud(folder / "scan.mcap", calibration, arm, cloud_path)
    for warning in result.warnings:
        print("warning:", warning)
    print(f"frames: {result.frames} of {result.all_frames}")
    print(f"points: {result.points}")

    # Points are in the arm frame; each has its uncertainty and the number of its frame.
    cloud = read_cloud(cloud_path)
    assert cloud.uncertainty_um is not None
    print(f"standard uncertainty in the laser plane: {np.median(cloud.uncertainty_um):.1f} µm")
    fit = fit_sphere(cloud.points_mm)
    print(f"radius: {fit.radius_mm:.3f} mm, true: {sphere.radius_mm:.3f} mm")
    print(f"distance of the points from the sphere: {1e3 * fit.rms_mm:.1f} µm rms")


if __name__ == "__main__":
    with tempfile.TemporaryDirectory() as temporary:
        main(Path(temporary))
