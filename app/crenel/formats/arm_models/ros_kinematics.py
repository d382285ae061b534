"""The factory calibration of a Universal Robots arm as ROS keeps it: ``kinematics`` in YAML.

The driver for ROS writes such a file (``..._calibration.yaml``) of the calibration in the arm's
controller; a description package has one of each type. Each joint is placed as in URDF, in metres
and radians, and turns about its z axis. The arm's base is that of the controller, and the last
link is the flange.
"""

import math
import re

import numpy as np

from crenel.errors import OperationError
from crenel.formats.arm_models.dh_units import refuse_impossible_length
from crenel.formats.arm_models.model import ImportedArm
from crenel.formats.arm_models.ur_calibration import LIMITS_RAD, MAKER
from crenel.formats.arm_models.urdf import UrdfJoint, joints_of_chain
from crenel.formats.datasheets.arm import error_part, joint_part
from crenel.messages.message import Text, message
from crenel.metrology.arm.link_error import LinkError, error_transform
from crenel.metrology.arm.near_frames import chain_length_mm
from crenel.units import MM_PER_M

LINKS = ("shoulder", "upper_arm", "forearm", "wrist_1", "wrist_2", "wrist_3")
TERMS = ("x", "y", "z", "roll", "pitch", "yaw")
_LINK = re.compile(rf"^[ \t]*({'|'.join(LINKS)})[ \t]*:", re.MULTILINE)
_TERM = re.compile(rf"\b({'|'.join(TERMS)})[ \t]*:[ \t]*([^\s}}]+?),?(?=[\s}}]|$)")


def is_ros_kinematics(text: str) -> bool:
    """Whether a text has ``kinematics`` with links of such an arm."""
    return re.search(r"^\s*kinematics\s*:", text, re.MULTILINE) is not None


def read_ros_kinematics(text: str) -> ImportedArm:
    """The arm that a file of kinematics describes.

    Raises:
        OperationError: a link or one of its numbers is missing or malformed, a link is there twice,
            or the arm is of another size than any such arm (``model-length-unit``).
    """
    places = list(_LINK.finditer(text))
    ends = [*(place.start() for place in places[1:]), len(text)]
    blocks = {place[1]: text[place.end() : end] for place, end in zip(places, ends, strict=True)}
    for link in LINKS:
        count = sum(place[1] == link for place in places)
        if count != 1:
            raise _refusal(link, message("ros-link-count", count=count))
    first, joints = joints_of_chain([_joint(link, blocks[link]) for link in LINKS])
    refuse_impossible_length(chain_length_mm(joints), "m", message("ros-has-metres"))
    return ImportedArm(
        message("source-ros-kinematics"),
        (),
        name=MAKER.strip(),
        base=error_part(first),
        joints=tuple(joint_part(joint) for joint in joints),
    )


def _refusal(link: str, why: Text) -> OperationError:
    what = message("ros-link-cannot-be-used", link=link)
    return OperationError("ros-kinematics-malformed", what, why, message("give-ros-kinematics"))


def _joint(link: str, block: str) -> UrdfJoint:
    """The joint before a link, by the text between its name and the next one's."""
    found = dict(_TERM.findall(block))
    x, y, z, roll, pitch, yaw = (_number(link, term, found.get(term, "")) for term in TERMS)
    placed = LinkError(x * MM_PER_M, y * MM_PER_M, z * MM_PER_M, roll, pitch, yaw)
    T = error_transform(placed)
    z_axis = np.array([0.0, 0.0, 1.0])
    name = f"J{LINKS.index(link) + 1}"
    return UrdfJoint(name, "revolute", "", link, T, z_axis, LIMITS_RAD, "")


def _number(link: str, term: str, text: str) -> float:
    try:
        number = float(text)
    except ValueError:
        number = math.nan
    if not math.isfinite(number):
        there = "yes" if text else "no"
        raise _refusal(link, message("ros-number", name=term, text=repr(text), there=there))
    return number
