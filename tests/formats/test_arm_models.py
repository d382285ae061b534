"""Models of arms as their makers state them: read as they mean it, asked about, or refused."""

import json
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from crenel.errors import OperationError
from crenel.formats.arm_models.import_model import read_model
from crenel.formats.arm_models.model import ImportedArm
from crenel.formats.datasheets.arm import TipPart, arm_document, parse_any_arm
from crenel.metrology.arm import near_frames
from crenel.metrology.arm.identification.identify import identify
from crenel.metrology.arm.identification.observations import ArmObservations
from crenel.metrology.arm.kinematics import Arm, flange_poses, link_transforms
from crenel.metrology.arm.near_frames import chain_length_mm, with_near_frames
from crenel.metrology.transforms import Floats
from tests.present import present
from tests.simulated_robots import Tracker, built, measure, postures
from tests.sources import ROOT

UR = """Joint 1: 0 0 0.1625 π/2
Joint 2: 0 −0.425 0 0
Joint 3: 0 −0.3922 0 0
Joint 4: 0 0 0.1333 π/2
Joint 5: 0 0 0.0997 −π/2
Joint 6: 0 0 0.0996 0"""
UR_HEAD = "θ [rad] a [m] d [m] α [rad]\n"
GERMAN = """a;alpha;d;theta
0;1,5708;0,1625;q1
-0,425;0;0;q2
-0,3922;0;0;q3
0;1,571;0,1333;q4
0;-1,5708;0,0997;q5
0;0;0,0996;q6"""
INCHES = """joint,theta (deg),d (inch),a (inch),alpha (deg)
1,0,6.397637795,0,90
2,0,0,-16.73228346,0
3,0,0,-15.44094488,0
4,0,5.248031496,0,90
5,0,3.92519685,0,-90
6,0,3.921259843,0,0"""
UNITS_IN_CELLS = """joint theta d a alpha
1 0 162.5 mm 0 90°
2 0 0 -425mm 0
3 0 0 -392.2 mm 0
4 0 133.3 0 90 deg
5 0° 99.7 0 -90°
6 0 99.6 0 0"""
CRAIG = """Modified Denavit-Hartenberg
| joint | alpha(deg) | a(mm) | d(mm) | theta(deg) |
|---|---|---|---|---|
| 1 | 0 | 0 | 162.5 | 0 |
| 2 | 90 | 0 | 0 | 0 |
| 3 | 0 | -425 | 0 | 0 |
| 4 | 0 | -392.2 | 133.3 | 0 |
| 5 | 90 | 0 | 99.7 | 0 |
| 6 | -90 | 0 | 0 | 0 |
| flange | 0 | 0 | 99.6 | 0 |"""
JOINT = """<joint name="{0}" type="{1}"><parent link="{2}"/><child link="{3}"/>
<origin xyz="{4}" rpy="{5}"/><axis xyz="{6}"/><limit lower="-6.2" upper="6.2"/></joint>"""
QUARTER = "1.5707963267948966 0 0"
TREE = (
    ("rail", "fixed", "world", "base", "3 0 0", "0 0 0", "1 0 0"),
    ("pan", "revolute", "base", "shoulder", "0 0 0.1625", "0 0 0", "0 0 1"),
    ("lift", "revolute", "shoulder", "upper", "0 0 0", QUARTER, "0 0 2"),
    ("elbow", "revolute", "upper", "fore", "-0.425 0.01 0", "3.1 0.2 0", "0 0 -1"),
    ("w1", "continuous", "fore", "wrist1", "-0.3922 0 -0.1333", QUARTER, "0 -1 0"),
    ("w2", "revolute", "wrist1", "wrist2", "0 0.02 0.0997", "0.3 -0.4 1", "1 2 -1"),
    ("w3", "revolute", "wrist2", "wrist3", "0 0 -0.0996", "3 0 0.7", "0 -1 0"),
    ("mount", "fixed", "wrist3", "tool0", "0.03 0.02 0.01", "0.1 0.2 0.3", "0 0 1"),
    ("finger", "prismatic", "wrist3", "gripper", "0 0 0", "0 0 0", "0 0 1"),
)
MESH = '<link name="world"><visual><geometry><mesh filename="package://ur/base.dae"/></geometry>'


def urdf(*changes: tuple[str, str]) -> str:
    text = "".join(JOINT.format(*row) for row in TREE)
    for before, after in changes:
        assert before in text
        text = text.replace(before, after)
    return f'<robot name="ur">{MESH}</visual></link>{text}</robot>'


UR5 = "Universal Robots UR5"
DELTAS = "".join(f"delta_{term} = [0, 0, 0, 0, 0, 0]\n" for term in ("theta", "a", "d", "alpha"))
CHAIN = {"end": "tool0", "base": "base"}
ORDER = "theta, a, d, alpha"
STANDARD = {"convention": "dh-standard"}


def with_tip(model: ImportedArm) -> dict[str, Any]:
    """The fields of ``arm.json``."""
    tip = TipPart(x_mm=0, y_mm=0, z_mm=100, diameter_mm=6)
    return {**model.fields(), "name": "Arm", "tip": tip.model_dump()}


def poses(model: ImportedArm) -> Floats:
    """The flange in three postures."""
    arm = parse_any_arm(json.dumps(with_tip(model)), Path("arm.json"))
    return flange_poses(arm, np.random.default_rng(3).uniform(-2, 2, (3, 6)))


@pytest.mark.parametrize(
    ("text", "answers"),
    [
        (UR, {"columns": ORDER, "length": "m", **STANDARD}),
        (UR_HEAD + UR, STANDARD),
        ("Standard D-H\n" + (UR_HEAD + UR).replace(" ", "\t"), {}),
        (GERMAN, {"length": "m", "angle": "rad", **STANDARD}),
        (INCHES, STANDARD),
        (CRAIG, {}),
        (UNITS_IN_CELLS, STANDARD),
    ],
    ids=["plain", "heads", "title", "decimal-commas", "inches", "craig-with-flange", "units"],
)
def test_one_arm_is_read_however_it_is_written(text: str, answers: dict[str, str]) -> None:
    expected = read_model("Standard\n" + UR_HEAD + UR, {})
    found = read_model(text, answers)
    assert not found.is_open
    np.testing.assert_allclose(poses(found), poses(expected), atol=1e-5)


@pytest.mark.parametrize(
    ("text", "likely"),
    [
        (UR, {"columns": ""}),
        (UR_HEAD + UR, {"convention": "dh-standard"}),
        (GERMAN, {"length": "m", "angle": "rad", "convention": "dh-standard"}),
        (CRAIG.removeprefix("Modified"), {"convention": "dh-modified"}),
    ],
)
def test_what_a_text_does_not_say_is_asked(text: str, likely: dict[str, str]) -> None:
    found = read_model(text, {})
    assert found.is_open
    assert {one.key: one.likely for one in found.questions if not one.answer} == likely


def test_the_chain_of_a_urdf_moves_as_the_robot() -> None:
    model = read_model(urdf(), CHAIN)
    assert not model.is_open
    q = np.random.default_rng(3).uniform(-2, 2, (3, 6))
    for one, found in zip(q, poses(model), strict=True):
        T, angles = np.eye(4), iter(one)
        for _, kind, _, _, xyz, rpy, axis in TREE[1:8]:
            placed, turned = np.eye(4), np.eye(4)
            placed[:3, :3] = Rotation.from_euler("xyz", [*map(float, rpy.split())]).as_matrix()
            placed[:3, 3] = [1000 * float(part) for part in xyz.split()]
            if kind != "fixed":
                direction = np.array([float(part) for part in axis.split()])
                vector = next(angles) * direction / np.linalg.norm(direction)
                turned[:3, :3] = Rotation.from_rotvec(vector).as_matrix()
            T = T @ placed @ turned
        np.testing.assert_allclose(found, T, atol=1e-9)


def test_the_ends_of_a_urdf_are_asked_and_what_does_not_matter_is_said() -> None:
    end = read_model(urdf(), {})
    assert [(one.key, one.likely) for one in end.questions] == [("end", "tool0")]
    assert end.questions[0].options == ("wrist2", "wrist3", "tool0", "gripper")
    said = " ".join(map(str, end.notes))
    for words in ("link wrist3, the robot branches: tool0, gripper", "One mesh", "±360°"):
        assert words in said
    base = read_model(urdf(), {"end": "tool0"}).questions[1]
    assert (base.options, base.likely) == (("world", "base", "shoulder"), "world")
    on_rail = urdf(('"rail" type="fixed"', '"rail" type="prismatic"'))
    assert read_model(on_rail, {"end": "tool0"}).questions[1].likely == "base"


def factory_files(arm: Arm) -> tuple[str, ...]:
    """``calibration.conf`` and ``urcontrol.conf`` of an arm that was calibrated as a UR5."""
    rows = {
        "theta": [one.theta_rad for one in arm.joints],
        "a": [one.a_mm / 1000 for one in arm.joints],
        "d": [one.d_mm / 1000 for one in arm.joints],
        "alpha": [one.alpha_rad for one in arm.joints],
    }
    nominal = {
        "a": [0, -0.425, -0.39225, 0, 0, 0],
        "d": [0.089159, 0, 0, 0.10915, 0.09465, 0.0823],
        "alpha": [np.pi / 2, 0, 0, np.pi / 2, -np.pi / 2, 0],
    }
    deltas = {
        f"delta_{term}": [*np.subtract(values, nominal.get(term, 0.0))]
        for term, values in rows.items()
    }
    return tuple(
        f"[{head}]\n" + "".join(f"{name} = {[*map(float, row)]}\n" for name, row in part.items())
        for head, part in (("mounting", deltas), ("DH", nominal))
    )


def nominal_arm() -> Arm:
    arm = parse_any_arm(json.dumps(with_tip(read_model("", {"robot": UR5}))), Path("arm.json"))
    assert isinstance(arm, Arm)
    return arm


def factory_arm() -> Arm:
    """A UR5 as it was made, its nearly parallel axes written by their common normals."""
    near = built(nominal_arm(), np.random.default_rng(6))
    links = link_transforms(near, np.zeros((1, 6)))[:, 0]
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(near_frames, "PARALLEL", 0.0)
        joints = near_frames.joints_of_links(links, near.joints)
    assert max(abs(one.d_mm) for one in joints) > 1e5
    return replace(near, joints=joints)


def test_frames_far_away_are_moved_near_the_arm() -> None:
    arm = factory_arm()
    near = with_near_frames(arm)
    assert chain_length_mm(near.joints) < 2500
    assert with_near_frames(near) is near
    q = np.random.default_rng(3).uniform(-2, 2, (100, 6))
    np.testing.assert_allclose(flange_poses(near, q), flange_poses(arm, q), atol=1e-9)
    table = "a [mm]; alpha [rad]; d [mm]; theta [rad]\n"
    rows = [(one.a_mm, one.alpha_rad, one.d_mm, one.theta_rad) for one in arm.joints]
    lines = [";".join(map(repr, map(float, row))) for row in rows]
    as_table = read_model("Standard\n" + table + "\n".join(lines), {})
    np.testing.assert_allclose(poses(as_table), flange_poses(arm, q)[[0, 1, 2]], atol=3e-9)


ROS_UR5E = """kinematics:
  shoulder: {x: 0, y: 0, z: 0.1625, roll: -0, pitch: 0, yaw: -0}
  upper_arm:
    x: 0
    y: 0
    z: 0
    roll: 1.5707963267948966
    pitch: 0
    yaw: -0
  forearm: {x: -0.425, y: 0, z: 0, roll: -0, pitch: 0, yaw: -0}
  wrist_1: {x: -0.3922, y: 0, z: 0.1333, roll: -0, pitch: 0, yaw: -0}
  wrist_2: {x: 0, y: -9.97e-2, z: -2.0e-11, roll: 1.5707963267948966, pitch: 0, yaw: -0}
  wrist_3:
    x: 0
    y: 0.0996
    z: 0
    roll: 1.5707963267948966
    pitch: 3.141592653589793
    yaw: 3.141592653589793
  hash: calib_209549117540498681
"""


def test_the_kinematics_of_ros_are_the_makers_table() -> None:
    found = read_model(ROS_UR5E, {})
    named = read_model("", {"robot": "Universal Robots UR5e"})
    for T, other in zip(poses(found), poses(named), strict=True):
        np.testing.assert_allclose(T, other, atol=1e-6)


@pytest.mark.parametrize(
    ("old", "new", "said"),
    [
        ("forearm", "elbow", "link forearm of the kinematics cannot be used: it is missing"),
        ("forearm", "wrist_1", "forearm of the kinematics cannot be used: it is missing"),
        ("-9.97e-2", "-9,97e-2", "y is '-9,97e-2', which is no number"),
        ("0.0996", ".nan", "y is '.nan', which is no number"),
        ("    pitch: 0\n", "", "upper_arm of the kinematics cannot be used: pitch is missing"),
        ("z: 0.1625", "z: 162.5", "Give the lengths in metres"),
    ],
)
def test_spoilt_kinematics_of_ros_are_refused(old: str, new: str, said: str) -> None:
    assert old in ROS_UR5E
    with pytest.raises(OperationError, match=said.replace(".", r"\.")):
        read_model(ROS_UR5E.replace(old, new, 1), {})


@pytest.mark.parametrize("both", [True, False])
def test_a_factory_calibration_is_moved_near_the_arm(both: bool) -> None:
    arm = factory_arm()
    deltas, nominal = factory_files(arm)
    text, answers = (deltas + nominal, {}) if both else (deltas, {"robot": UR5})
    found = read_model(text, answers)
    assert max(abs(one.d_mm) for one in found.joints) < 2000
    assert "m away" in " ".join(map(str, found.notes))
    q = np.random.default_rng(3).uniform(-2, 2, (3, 6))
    np.testing.assert_allclose(poses(found), flange_poses(arm, q), atol=3e-9)
    read = parse_any_arm(arm_document(arm).text(), Path("arm.json"))
    assert isinstance(read, Arm)
    assert chain_length_mm(read.joints) < 2500
    np.testing.assert_allclose(flange_poses(read, q), flange_poses(arm, q), atol=3e-9)


@pytest.mark.slow
def test_a_factory_calibration_is_identified_as_well_as_the_catalogue() -> None:
    rng = np.random.default_rng(7)
    factory = parse_any_arm(arm_document(factory_arm()).text(), Path("arm.json"))
    assert isinstance(factory, Arm)
    true = built(factory, rng, 0.1, 2e-4)
    seen = measure(true, postures(true, 60, rng), Tracker.somewhere(rng, 0.02), rng)
    found = [
        identify(arm, ArmObservations((), (), (), (seen,))) for arm in (factory, nominal_arm())
    ]
    after_um = [present(one.validation.after.coordinates_um) for one in found]
    assert after_um[0] == pytest.approx(after_um[1], rel=0.05)
    assert after_um[0] < 60
    assert "m away in arm.json" in str(found[0].warnings[0])


def test_nominal_models_are_listed_with_their_sources() -> None:
    listed = read_model("", {}).questions[0].options
    documented = (ROOT / "docs/formats.md").read_text()
    for name in listed:
        model = read_model("", {"robot": name})
        assert parse_any_arm(json.dumps(with_tip(model)), Path("arm.json"))
        assert f"| `{name}` | {model.source.values['source']} |" in documented  # type: ignore[union-attr]
    ur5e = read_model("", {"robot": "Universal Robots UR5e"})
    np.testing.assert_allclose(poses(ur5e), poses(read_model("Standard\n" + UR_HEAD + UR, {})))


W1 = '"w1" type="continuous"'
NO_ARM = ('type="revolute"', 'type="prismatic"')
BAD = {
    "no delta_d": (DELTAS.replace("delta_d", "d"), {}, "ur-row-malformed", "delta_d is missing"),
    "five": (DELTAS.replace("[0, 0,", "[0,"), {}, "ur-row-malformed", "delta_theta is damaged"),
    "not calibrated": (f"calibration_status = 0\n{DELTAS}", {}, "ur-not-calibrated", "calibration"),
    "no such robot": (DELTAS, {"robot": "UR4"}, "model-answer-unknown", "UR5e"),
    "prismatic": (urdf((W1, '"w1" type="prismatic"')), CHAIN, "urdf-joint-not-rotary", "it slides"),
    "planar": (urdf((W1, '"w1" type="planar"')), CHAIN, "urdf-joint-not-rotary", "planar"),
    "gripper": (urdf(), {**CHAIN, "end": "gripper"}, "urdf-joint-not-rotary", "finger"),
    "mimic": (
        urdf(('<axis xyz="0 0 2"/>', '<axis xyz="0 0 2"/><mimic joint="pan"/>')),
        CHAIN,
        "urdf-joint-not-free",
        "follows joint pan",
    ),
    "no arm": (urdf(NO_ARM), {}, "urdf-chain", "6 prismatic"),
    "no such link": (urdf(), {"end": "hand"}, "model-answer-unknown", "wrist2"),
    "circle": (urdf(('link="world"', 'link="tool0"')), {}, "urdf-malformed", "circle"),
    "mm": (
        urdf(("-0.425", "-425"), ("-0.3922", "-392.2")),
        CHAIN,
        "model-length-unit",
        "in metres",
    ),
    "numbers": (urdf(("0.1 0.2 0.3", "0.1 0,2 0.3")), {}, "urdf-malformed", "0,2"),
    "no axis": (urdf(('"0 0 2"', '"0 0 0"')), {}, "urdf-malformed", "lift"),
    "xacro": (urdf(("0.1625", "${d1}")), {}, "urdf-is-xacro", "xacro FILE"),
    "other XML": ("<sdf/>", {}, "model-not-recognized", "sdf"),
    "cut off": (urdf()[:300], {}, "xml-malformed", "URDF"),
    "missing row": (UR.replace("Joint 3: 0 −0.3922 0 0\n", ""), {}, "dh-row-missing", "joint 3"),
    "row twice": (UR.replace("Joint 3", "Joint 2"), {}, "dh-row-missing", "joint 3"),
    "four joints": ("\n".join(GERMAN.splitlines()[:5]), {}, "dh-joint-count", "not 4"),
    "commas": (GERMAN.replace(";", ","), {}, "row-length", "decimal point"),
    "both signs": (GERMAN.replace("0,0996", "0.0996"), {}, "decimal-signs-mixed", "0.0996"),
    "columns": (UR.replace("π", "0 π"), {}, "dh-columns", "6 cells"),
    "a column less": (UR_HEAD.replace("d [m] ", "") + UR, {}, "dh-columns", "no column for d"),
    "a cell less": (UR_HEAD + UR.replace("0.0997 ", ""), {}, "row-length", "line 6 has 4 cells"),
    "no number": (UR_HEAD + UR.replace("0.0997", "O.0997"), {}, "cell-not-a-number", "O.0997"),
    "slides": (GERMAN.replace("0,1333", "q4"), {}, "dh-joint-not-rotary", "slides"),
    "inches called mm": (INCHES.replace("inch", "mm"), {}, "model-length-unit", "no arm is so"),
    "m called mm": (UR_HEAD.replace("[m]", "[mm]") + UR, {}, "model-length-unit", "in m is an arm"),
    "two units": (INCHES.replace("a (inch)", "a (mm)"), {}, "model-length-unit", "inch, mm"),
    "degrees called radians": (
        INCHES.replace("deg", "rad"),
        {},
        "model-angle-unit",
        "these are degrees",
    ),
    "radians called degrees": (
        GERMAN,
        {"length": "m", "angle": "deg"},
        "model-angle-unit",
        "these are radians",
    ),
    "two units in cells": (
        UNITS_IN_CELLS.replace("-425mm", "-42 cm"),
        {},
        "model-length-unit",
        "cm",
    ),
    "no lengths": ("a alpha d theta\n" + 6 * "0 90 0 0\n", {}, "model-length-unit", "all lengths"),
    "no such unit": (GERMAN, {"length": "feet"}, "model-answer-unknown", "mm, cm, m, inch"),
    "no table": ("see the manual, page 24", {}, "model-not-recognized", "Paste a line for each"),
}


@pytest.mark.parametrize("case", BAD)
def test_bad_input_is_refused_in_one_sentence(case: str) -> None:
    text, answers, code, words = BAD[case]
    with pytest.raises(OperationError) as caught:
        read_model(text, answers)
    assert (caught.value.code, words.lower() in caught.value.line.lower()) == (code, True), (
        caught.value.line
    )
