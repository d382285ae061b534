"""Recognizes what a text with a model of an arm is, reads it, and makes ``arm.json`` of it."""

from pathlib import Path

from crenel.errors import OperationError
from crenel.formats.arm_models.dh_model import read_dh_model
from crenel.formats.arm_models.model import Answers, ImportedArm, ModelQuestion
from crenel.formats.arm_models.nominal_arms import nominal_arms, read_nominal_arm
from crenel.formats.arm_models.ros_kinematics import is_ros_kinematics, read_ros_kinematics
from crenel.formats.arm_models.ur_calibration import is_ur_calibration, read_ur_calibration
from crenel.formats.arm_models.urdf import is_urdf, read_urdf
from crenel.formats.atomic_write import check_output_path
from crenel.formats.datasheets.arm import ArmFile, TipPart
from crenel.formats.file_names import display_path
from crenel.formats.io_errors import prefix_errors
from crenel.formats.json_document import read_text
from crenel.messages.message import Text, join, message


def read_model(text: str, answers: Answers) -> ImportedArm:
    """The arm that a text describes: a Denavit-Hartenberg table, URDF, or the factory
    calibration of a Universal Robots arm as its controller or ROS has it.

    Args:
        text: pasted, or of a file. Without one, a robot of the program's own list is asked for.
        answers: what a person said to the questions of an earlier call.

    Returns:
        The joints, or the questions that are open.

    Raises:
        OperationError: it is nothing of this kind, it is incomplete or malformed, or an answer
            cannot be true.
    """
    if not text.strip():
        return read_nominal_arm(answers)
    if is_urdf(text):
        return read_urdf(text, answers)
    if is_ros_kinematics(text):
        return read_ros_kinematics(text)
    if is_ur_calibration(text):
        return read_ur_calibration(text, answers)
    return read_dh_model(text, answers)


def import_arm_file(
    source: Path,
    output: Path,
    answers: Answers,
    tip: tuple[float, float, float, float],
    name: str = "",
    serial_number: str = "",
) -> tuple[ArmFile, ImportedArm]:
    """Writes ``arm.json`` of the model in a file.

    Args:
        source: a file, or the name of a robot of the program's own list.
        answers: what the file leaves open, by the keys of the questions.
        tip: its centre in the flange frame and its diameter, mm.
        name: of the arm; that in the file, or the file's own, if it is empty.

    Raises:
        OperationError: the file has no model or a damaged one; a question is open
            (``model-questions-open``); or ``arm.json`` cannot be written. Nothing is then written.
    """
    check_output_path(output, [source])
    if str(source) in nominal_arms() and not source.exists():
        model = read_nominal_arm({"robot": str(source)})
    else:
        text = read_text(source)
        with prefix_errors(source):
            model = read_model(text, answers)
    if model.is_open:
        raise OperationError(
            "model-questions-open",
            message("model-leaves-open", path=display_path(source)),
            join([_open_text(one) for one in model.questions if not one.answer], "; "),
            message("say-what-is-open"),
        )
    x_mm, y_mm, z_mm, diameter_mm = tip
    document = ArmFile(
        name=name or model.name or source.stem,
        serial_number=serial_number,
        convention=model.convention,
        base=model.base,
        joints=model.joints,
        tip=TipPart(x_mm=x_mm, y_mm=y_mm, z_mm=z_mm, diameter_mm=diameter_mm),
    )
    document.write(output)
    return document, model


def _open_text(question: ModelQuestion) -> Text:
    options = " | ".join(question.options)
    if not question.likely:
        return message("model-open", key=question.key, options=options)
    return message(
        "model-open-likely",
        key=question.key,
        options=options,
        likely=question.likely,
        why=question.why,
    )
