"""Arms from URDF, the robot description of ROS: the chain between two links of the tree.

A joint of the chain is ``T(xyz) Rz(yaw) Ry(pitch) Rx(roll)`` from its parent, in metres and
radians, and then turns about its ``axis``. Shapes, inertias and meshes do not matter.
"""

import math
from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from xml.etree import ElementTree as ET

import numpy as np

from crenel.errors import OperationError
from crenel.formats.arm_models.dh_units import refuse_impossible_length
from crenel.formats.arm_models.model import Answers, ImportedArm, ModelQuestion, answer_to
from crenel.formats.datasheets.arm import JOINT_COUNTS, error_part, joint_part
from crenel.formats.xml_text import parse_xml
from crenel.messages.message import Text, message
from crenel.metrology.arm.kinematics import Joint
from crenel.metrology.arm.link_error import LinkError, error_from_transform, error_transform
from crenel.metrology.arm.near_frames import chain_length_mm, joints_of_links
from crenel.metrology.transforms import Floats
from crenel.units import MM_PER_M

TURNS = ("revolute", "continuous")
FULL_TURN = 2 * math.pi
FLANGES = ("flange", "tool0", "link_eef", "ee_link")
"""Names of the link at which a tool is mounted."""


@dataclass(frozen=True)
class UrdfJoint:
    """A joint of the tree."""

    name: str
    kind: str
    parent: str
    child: str
    T_parent_joint: Floats
    """(4, 4) mm, at the angle zero."""
    axis: Floats
    """(3,) unit vector in the frame of the joint."""
    limits_rad: tuple[float, float]
    follows: str
    """The joint that it mimics; empty if it is free."""


def is_urdf(text: str) -> bool:
    """Whether a text is XML."""
    return text.lstrip("\ufeff \t\r\n").startswith("<")


def read_urdf(text: str, answers: Answers) -> ImportedArm:
    """The arm between two links of a robot.

    Args:
        text: of the file.
        answers: what the person said: ``base`` and ``end`` of the chain.

    Raises:
        OperationError: it is no URDF; no chain of five to seven rotary joints can be used; or an
            answer cannot be true.
    """
    root = parse_xml(text, Path("URDF"))
    _refuse_others(root, text)
    joints = [_read_joint(element) for element in root.findall("joint")]
    by_child = {joint.child: joint for joint in joints}
    children: dict[str, list[str]] = {one.get("name", ""): [] for one in root.findall("link")}
    for joint in joints:
        children.setdefault(joint.parent, []).append(joint.child)
        children.setdefault(joint.child, [])
    source = message("source-urdf", name=root.get("name", ""))
    notes = _notes(root, children, joints)
    end = _ask_end(children, by_child, answers)
    if not end.answer:
        return ImportedArm(source, (end,), notes=notes)
    base = _ask_base(end.answer, by_child, answers)
    if not base.answer:
        return ImportedArm(source, (end, base), notes=notes)
    chain = _chain(base.answer, end.answer, by_child)
    _refuse_chain(chain, base.answer, end.answer)
    first, arm = joints_of_chain(chain)
    refuse_impossible_length(chain_length_mm(arm), "m", message("urdf-has-metres"))
    return ImportedArm(
        source,
        (end, base),
        name=root.get("name", ""),
        base=error_part(first),
        joints=tuple(joint_part(joint) for joint in arm),
        notes=notes,
    )


def _refuse_others(root: ET.Element, text: str) -> None:
    if root.tag != "robot":
        raise OperationError(
            "model-not-recognized",
            message("xml-is-no-urdf", name=root.tag),
            remedy=message("give-urdf"),
        )
    if "${" in text or any("wiki/xacro}" in one.tag for one in root.iter()):
        raise OperationError(
            "urdf-is-xacro", message("urdf-is-xacro"), remedy=message("expand-xacro")
        )
    if not root.findall("joint"):
        raise OperationError(
            "model-not-recognized", message("urdf-without-joints"), remedy=message("give-urdf")
        )


def _read_joint(element: ET.Element) -> UrdfJoint:
    name = element.get("name", "")
    origin, limit = element.find("origin"), element.find("limit")
    x, y, z = _numbers(name, origin, "xyz", (0.0, 0.0, 0.0))
    roll, pitch, yaw = _numbers(name, origin, "rpy", (0.0, 0.0, 0.0))
    placed = LinkError(x * MM_PER_M, y * MM_PER_M, z * MM_PER_M, roll, pitch, yaw)
    axis = np.array(_numbers(name, element.find("axis"), "xyz", (1.0, 0.0, 0.0)))
    length = float(np.linalg.norm(axis))
    if length == 0:
        raise OperationError(
            "urdf-malformed", message("urdf-axis-is-zero", name=name), remedy=message("give-urdf")
        )
    (low,) = _numbers(name, limit, "lower", (-FULL_TURN,))
    (high,) = _numbers(name, limit, "upper", (FULL_TURN,))
    if element.get("type") == "continuous" or low >= high:
        low, high = -FULL_TURN, FULL_TURN
    mimic = element.find("mimic")
    return UrdfJoint(
        name,
        element.get("type", ""),
        _link_name(element, "parent"),
        _link_name(element, "child"),
        error_transform(placed),
        axis / length,
        (low, high),
        "" if mimic is None else mimic.get("joint", ""),
    )


def _link_name(element: ET.Element, tag: str) -> str:
    found = element.find(tag)
    return "" if found is None else found.get("link", "")


def _numbers(
    joint: str, element: ET.Element | None, name: str, missing: tuple[float, ...]
) -> tuple[float, ...]:
    text = None if element is None else element.get(name)
    if text is None:
        return missing
    try:
        values = tuple(float(part) for part in text.split())
    except ValueError:
        values = ()
    if len(values) != len(missing) or not all(map(math.isfinite, values)):
        raise OperationError(
            "urdf-malformed",
            message("urdf-numbers", joint=joint, name=name, text=repr(text)),
            message("urdf-numbers-expected", count=len(missing)),
            message("give-urdf"),
        )
    return values


def _ask_end(
    children: Mapping[str, Sequence[str]], by_child: Mapping[str, UrdfJoint], answers: Answers
) -> ModelQuestion:
    """At which link the arm ends.

    Raises:
        OperationError: no link has enough rotary joints before it.
    """
    turning = {link: len(_rotary(_chain("", link, by_child))) for link in children}
    usable = tuple(link for link in children if turning[link] >= min(JOINT_COUNTS))
    if not usable:
        raise OperationError(
            "urdf-chain",
            message("urdf-chain-too-short", joints=max(turning.values(), default=0)),
            _kinds_text(by_child.values()),
            message("rotary-joints-only"),
        )
    question = ModelQuestion("end", usable)
    flanges = [link for link in usable if link.lower() in FLANGES]
    ends = [link for link in usable if not children[link]]
    if flanges:
        question = replace(question, likely=flanges[0], why=message("urdf-flange"))
    elif len(ends) == 1:
        question = replace(question, likely=ends[0], why=message("urdf-only-end"))
    return replace(question, answer=answer_to(question, answers))


def _ask_base(end: str, by_child: Mapping[str, UrdfJoint], answers: Answers) -> ModelQuestion:
    """At which link the arm begins: any before the end with few enough joints between."""
    chain = _chain("", end, by_child)
    starts = tuple(
        joint.parent
        for k, joint in enumerate(chain)
        if min(JOINT_COUNTS) <= len(_rotary(chain[k:])) <= max(JOINT_COUNTS)
    )
    if not starts:
        raise OperationError(
            "urdf-chain",
            message("urdf-chain-too-long", joints=len(_rotary(chain)), end=end),
            remedy=message("choose-another-end"),
        )
    question = ModelQuestion("base", starts)
    usable = [link for link in starts if _is_free(_chain(link, end, by_child))]
    if usable:
        question = replace(question, likely=usable[0], why=message("urdf-first-link"))
    return replace(question, answer=answer_to(question, answers))


def _chain(base: str, end: str, by_child: Mapping[str, UrdfJoint]) -> list[UrdfJoint]:
    """The joints from a link to another; from the root of the tree for an empty name.

    Raises:
        OperationError: links follow each other in a circle.
    """
    found: list[UrdfJoint] = []
    link = end
    while link != base and link in by_child:
        found.append(by_child[link])
        link = by_child[link].parent
        if len(found) > len(by_child):
            what = message("urdf-circle", link=end)
            raise OperationError("urdf-malformed", what, remedy=message("give-urdf"))
    return found[::-1]


def _is_free(chain: Sequence[UrdfJoint]) -> bool:
    """Whether all joints are fixed or free rotary ones."""
    return all(one.kind in (*TURNS, "fixed") and not one.follows for one in chain)


def _rotary(chain: Iterable[UrdfJoint]) -> list[UrdfJoint]:
    return [joint for joint in chain if joint.kind in TURNS and not joint.follows]


def _refuse_chain(chain: Sequence[UrdfJoint], base: str, end: str) -> None:
    """Refuses joints between base and end that are no free rotary ones."""
    for joint in chain:
        if joint.kind not in (*TURNS, "fixed"):
            raise OperationError(
                "urdf-joint-not-rotary",
                message("urdf-joint-cannot-be-used", joint=joint.name, base=base, end=end),
                message("urdf-joint-kind", kind=joint.kind),
                message("rotary-joints-only"),
            )
        if joint.follows:
            raise OperationError(
                "urdf-joint-not-free",
                message("urdf-joint-cannot-be-used", joint=joint.name, base=base, end=end),
                message("urdf-joint-follows-not-reported", other=joint.follows),
                message("rotary-joints-only"),
            )


def joints_of_chain(chain: Sequence[UrdfJoint]) -> tuple[LinkError, tuple[Joint, ...]]:
    """The transform before the first of five to seven free rotary joints, with fixed ones between
    them, and the rotary joints in the standard convention."""
    before: list[Floats] = []
    T = np.eye(4)
    for joint in chain:
        T = T @ joint.T_parent_joint
        if joint.kind in TURNS:
            turned = _rotation_onto(joint.axis)
            before.append(T @ turned)
            T = turned.T
    links = np.array([*before[1:], T])
    first = before[0]
    if np.allclose(first[:3, 2], [0, 0, 1], atol=1e-12) and np.allclose(first[:2, 3], 0, atol=1e-9):
        links[0] = first @ links[0]  # along and about the first axis, it is part of the first link
        first = np.eye(4)
    joints = [
        Joint(joint.name, 0.0, 0.0, 0.0, 0.0, limits_rad=joint.limits_rad)
        for joint in _rotary(chain)
    ]
    return error_from_transform(first), joints_of_links(links, joints)


def _rotation_onto(axis: Floats) -> Floats:
    """(4, 4) the smallest rotation that turns z into a unit vector."""
    T = np.eye(4)
    x, y, z = axis
    if z < -1 + 1e-12:
        T[:3, :3] = np.diag([1.0, -1.0, -1.0])
        return T
    T[:3, :3] = [
        [1 - x * x / (1 + z), -x * y / (1 + z), x],
        [-x * y / (1 + z), 1 - y * y / (1 + z), y],
        [-x, -y, z],
    ]
    return T


def _notes(
    root: ET.Element, children: Mapping[str, Sequence[str]], joints: Sequence[UrdfJoint]
) -> tuple[Text, ...]:
    """Where the tree branches, and what of the file does not matter."""
    notes: list[Text] = [
        message("urdf-branches", link=link, links=", ".join(found))
        for link, found in children.items()
        if len(found) > 1
    ]
    meshes = sum(1 for _ in root.iter("mesh"))
    if meshes:
        notes.append(message("urdf-meshes", count=meshes))
    if any(joint.kind == "continuous" for joint in joints):
        notes.append(message("urdf-continuous"))
    return tuple(notes)


def _kinds_text(joints: Iterable[UrdfJoint]) -> Text:
    kinds = Counter(joint.kind for joint in joints)
    return message("urdf-kinds", kinds=", ".join(f"{n} {kind}" for kind, n in kinds.items()))
