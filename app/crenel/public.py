"""The public interface of the package ``crenel``, which serves these names as its own."""

from crenel.errors import OperationError
from crenel.formats.clouds.files import read_cloud
from crenel.formats.clouds.points import Cloud
from crenel.formats.datasheets.arm import read_any_arm
from crenel.formats.datasheets.target import read_object
from crenel.formats.images import read_grey
from crenel.formats.recording.writer import RecordingWriter
from crenel.formats.results.calibration import (
    Calibration,
    CalibrationFile,
    calibration_from_document,
    read_calibration,
)
from crenel.gauges.quick.clouds.document import GaugeReport
from crenel.gauges.quick.clouds.evaluate import verify_clouds
from crenel.metrology.arm.kinematics import Arm, RobotArm
from crenel.metrology.chessboard.board_detection import BoardDetection
from crenel.metrology.chessboard.detect_board import detect_board
from crenel.metrology.detection.detect_block import ObjectDetection, detect_object
from crenel.metrology.detection.failure_evidence import DetectionError
from crenel.metrology.fitting.plane_sphere import fit_plane, fit_sphere
from crenel.metrology.sensor.triangulation import sensor_points
from crenel.metrology.stripe import StripeSettings, extract_stripe
from crenel.metrology.stripe.points import Stripe
from crenel.metrology.targets.chessboard import Chessboard
from crenel.metrology.targets.crenellated_block import Crenellated
from crenel.workflows.calibrate import calibrate_session
from crenel.workflows.reconstruct import Reconstruction, reconstruct_cloud, reconstruct_points

__all__ = [
    "Arm",
    "BoardDetection",
    "Calibration",
    "CalibrationFile",
    "Chessboard",
    "Cloud",
    "Crenellated",
    "DetectionError",
    "GaugeReport",
    "ObjectDetection",
    "OperationError",
    "Reconstruction",
    "RecordingWriter",
    "RobotArm",
    "Stripe",
    "StripeSettings",
    "calibrate_session",
    "calibration_from_document",
    "detect_board",
    "detect_object",
    "extract_stripe",
    "fit_plane",
    "fit_sphere",
    "read_any_arm",
    "read_calibration",
    "read_cloud",
    "read_grey",
    "read_object",
    "reconstruct_cloud",
    "reconstruct_points",
    "sensor_points",
    "verify_clouds",
]
