"""The factory calibration of a Universal Robots arm: ``calibration.conf`` and ``urcontrol.conf``.

``[mounting]`` of the one has what is added to theta, a, d and alpha of each joint; ``[DH]`` of the
other has a, d and alpha themselves. Lengths are in metres, angles in radians. The three parallel
axes put link frames up to kilometres away, whose large d cancel out.
"""

import math
import re
from collections.abc import Mapping

import numpy as np

from crenel.errors import OperationError
from crenel.formats.arm_models.model import Answers, ImportedArm, ModelQuestion, answer_to
from crenel.formats.arm_models.nominal_arms import nominal_arms
from crenel.formats.datasheets.arm import joint_part
from crenel.messages.message import Text, message, quantity
from crenel.metrology.arm.kinematics import Arm, Joint, Tip
from crenel.metrology.arm.near_frames import with_near_frames
from crenel.metrology.transforms import Floats
from crenel.units import MM_PER_M

TERMS = ("theta", "a", "d", "alpha")
JOINTS = 6
LIMITS_RAD = (-2 * math.pi, 2 * math.pi)
MAKER = "Universal Robots "
_ROW = re.compile(r"^\s*(\w+)\s*=\s*\[([^\]]*)\]", re.MULTILINE)
_STATUS = re.compile(r"^\s*calibration_status\s*=\s*(\d+)", re.MULTILINE)


def is_ur_calibration(text: str) -> bool:
    """Whether a text has rows as these files have them."""
    rows = {found[1] for found in _ROW.finditer(text)}
    return any(f"delta_{term}" in rows for term in TERMS) or {"a", "d", "alpha"} <= rows


def read_ur_calibration(text: str, answers: Answers) -> ImportedArm:
    """The arm of a factory calibration, with its link frames near the arm.

    Args:
        text: of ``calibration.conf``, of ``urcontrol.conf``, or of both one after the other.
        answers: what the person said: ``robot``, if ``[DH]`` is not in the text.

    Raises:
        OperationError: rows are missing or malformed; the arm was not calibrated; or the answer is
            no robot of the list.
    """
    rows = {found[1]: found[2] for found in _ROW.finditer(text)}
    deltas = _read_rows(rows, "delta_")
    status = _STATUS.search(text)
    if deltas and status is not None and int(status[1]) == 0:
        raise OperationError(
            "ur-not-calibrated", message("ur-not-calibrated"), remedy=message("give-ur-files")
        )
    source = message("source-ur-calibration", calibrated="yes" if deltas else "no")
    asked: tuple[ModelQuestion, ...] = ()
    if "alpha" in rows:
        nominal = {"theta": np.zeros(JOINTS), **_read_rows(rows, "")}
    else:
        robots = tuple(name for name in nominal_arms() if name.startswith(MAKER))
        question = ModelQuestion("robot", robots)
        answer = answer_to(question, answers)
        asked = (ModelQuestion("robot", robots, answer),)
        if not answer:
            return ImportedArm(source, asked)
        nominal = _nominal_rows(answer)
    terms = {term: nominal[term] + deltas.get(term, 0.0) for term in TERMS}
    arm = _arm_of(terms)
    near = with_near_frames(arm)
    notes: list[Text] = []
    if not deltas:
        notes.append(message("ur-nominal-only"))
    if near.frames_moved_mm:
        far = quantity(near.frames_moved_mm / MM_PER_M, "m", 0)
        notes.append(message("frames-moved-near-the-arm", far=far))
    return ImportedArm(
        source,
        asked,
        name=asked[0].answer if asked else MAKER.strip(),
        joints=tuple(joint_part(joint) for joint in near.joints),
        notes=tuple(notes),
    )


def _arm_of(terms: Mapping[str, Floats]) -> Arm:
    joints = tuple(
        Joint(
            f"J{k + 1}",
            float(terms["a"][k]),
            float(terms["alpha"][k]),
            float(terms["d"][k]),
            float(terms["theta"][k]),
            limits_rad=LIMITS_RAD,
        )
        for k in range(JOINTS)
    )
    return Arm("", "", joints, Tip(0.0, 0.0, 0.0, 1.0))


def _read_rows(rows: Mapping[str, str], prefix: str) -> dict[str, Floats]:
    """The rows of a, d, alpha, and with a prefix of theta, in mm and rad; empty if none is there.

    Raises:
        OperationError: some are missing, or have other than six numbers.
    """
    wanted = [prefix + term for term in TERMS if prefix or term != "theta"]
    if not any(name in rows for name in wanted):
        return {}
    found = {}
    for name in wanted:
        try:
            numbers = np.array([float(part) for part in rows.get(name, "").split(",")])
        except ValueError:
            numbers = np.zeros(0)
        if len(numbers) != JOINTS or not np.isfinite(numbers).all():
            raise OperationError(
                "ur-row-malformed",
                message("ur-row-malformed", name=name, there="yes" if name in rows else "no"),
                message("ur-six-numbers"),
                message("give-ur-files"),
            )
        term = name.removeprefix(prefix)
        found[term] = numbers * MM_PER_M if term in ("a", "d") else numbers
    return found


def _nominal_rows(robot: str) -> dict[str, Floats]:
    a_mm, alpha_deg, d_mm, theta_deg = np.array(nominal_arms()[robot].rows).T
    return {
        "a": a_mm,
        "alpha": np.deg2rad(alpha_deg),
        "d": d_mm,
        "theta": np.deg2rad(theta_deg),
    }
