"""Real recordings of robot, camera, laser and chessboard, as session folders."""

import ast
from pathlib import Path

import cv2
import numpy as np
from scipy.spatial.transform import Rotation

from crenel.formats.datasheets.sensor import SensorDatasheet
from crenel.formats.images import GreyImage, write_png
from crenel.formats.session.pose_pictures import ImageRow, write_images
from crenel.metrology.arm.kinematics import RobotArm
from crenel.metrology.targets.chessboard import Chessboard
from crenel.metrology.transforms import Floats, rigid
from tests.datasheets import write_arm, write_object

# Printed on paper; its squares were not measured more closely than a ruler does.
BOARD = Chessboard("printed chessboard", "", (7, 6), 10.0, 0.05)
ROBOT = RobotArm("industrial robot", "")  # nothing was touched: it has no tip


def write_real_session(recording: Path, folder: Path) -> Path:
    """Writes a folder of ``frameNNNN.png`` and ``poseNNNN.txt`` as a session."""
    frames = sorted(recording.glob("frame*.png"))
    (folder / "images").mkdir(parents=True)
    height, width = read_grey_image(frames[0]).shape
    write_arm(folder / "arm.json", ROBOT)
    write_object(folder / "object.json", BOARD)
    document = {"name": "camera and laser", "serial_number": "", "stripe_axis": "v"}
    sensor = SensorDatasheet.model_validate({**document, "width_px": width, "height_px": height})
    sensor.write(folder / "sensor.json")
    rows = []
    for frame in frames:
        number = frame.stem.removeprefix("frame")
        write_png(folder / "images" / frame.name, read_grey_image(frame))
        pose = read_pose(recording / f"pose{number}.txt")
        rows.append(ImageRow(int(number), f"images/{frame.name}", "both", np.zeros(0), pose))
    write_images(folder / "images.csv", rows)
    return folder


def read_grey_image(path: Path) -> GreyImage:
    """A frame, whose three channels are alike, as one."""
    image = cv2.imread(str(path), cv2.IMREAD_UNCHANGED)
    assert image is not None
    return np.ascontiguousarray(image if image.ndim == 2 else image[..., 0]).astype(np.uint8)


def read_pose(path: Path) -> Floats:
    """``T_arm_flange`` (4, 4) in mm of a file ``((x, y, z) in m, (qx, qy, qz, qw))``."""
    place_m, quaternion = ast.literal_eval(path.read_text())
    return rigid(Rotation.from_quat(quaternion).as_matrix(), 1e3 * np.array(place_m))
