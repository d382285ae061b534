"""Models of arms as their makers state them: read as they mean it, asked about, or refused."""

import json
from pathlib import Path

import numpy as np
import pytest

from app.errors import OperationError
from app.formats.arm_models.import_model import read_model
from app.formats.arm_models.model import ImportedArm
from app.formats.datasheets.arm import TipPart, parse_any_arm
from app.metrology.arm.kinematics import flange_poses
from app.metrology.transforms import Floats

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
ORDER = "theta, a, d, alpha"
STANDARD = {"convention": "dh-standard"}


def poses(model: ImportedArm) -> Floats:
    """The flange in three postures."""
    tip = TipPart(x_mm=0, y_mm=0, z_mm=100, diameter_mm=6)
    fields = {**model.fields(), "name": "Arm", "tip": tip.model_dump()}
    arm = parse_any_arm(json.dumps(fields), Path("arm.json"))
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
    ],
    ids=["plain", "heads", "title", "decimal-commas", "inches", "craig-with-flange"],
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


BAD = {
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
