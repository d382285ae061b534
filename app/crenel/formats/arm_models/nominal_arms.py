"""Nominal models of common robots, from the tables that their makers publish."""

from dataclasses import replace
from functools import lru_cache
from importlib import resources
from typing import Literal

from pydantic import TypeAdapter

from crenel.formats.arm_models.model import Answers, ImportedArm, ModelQuestion, answer_to
from crenel.formats.datasheets.arm import ErrorPart, JointPart
from crenel.formats.json_document import DocumentPart, Number
from crenel.messages.message import message

Row = tuple[Number, Number, Number, Number]


class NominalArm(DocumentPart):
    """A robot as its maker states it."""

    name: str
    """With that of its maker."""
    source: str
    """The publication of the maker."""
    convention: Literal["dh-standard", "dh-modified"]
    rows: tuple[Row, ...]
    """a in mm, alpha in degrees, d in mm, theta in degrees of each joint."""
    limits_deg: tuple[tuple[Number, Number], ...]
    base_turn_x_deg: Number = 0.0
    """The turn of the base frame about its x axis, before the first joint."""
    flange_mm: Number = 0.0
    """How far the flange lies behind the last frame, along its z axis."""


@lru_cache
def nominal_arms() -> dict[str, NominalArm]:
    """All robots that the program knows, by their names."""
    text = resources.files(__package__).joinpath("nominal_arms.json").read_text("utf-8")
    arms = TypeAdapter(tuple[NominalArm, ...]).validate_json(text)
    return {arm.name: arm for arm in arms}


def read_nominal_arm(answers: Answers) -> ImportedArm:
    """The model of the robot that a person chose, or the question which.

    Raises:
        OperationError: there is none of this name.
    """
    question = ModelQuestion("robot", tuple(nominal_arms()))
    name = answer_to(question, answers)
    asked = (replace(question, answer=name),)
    if not name:
        return ImportedArm(message("source-robot-of-the-list"), asked)
    arm = nominal_arms()[name]
    rows = zip(arm.rows, arm.limits_deg, strict=True)
    joints = [
        JointPart(
            name=f"J{number}", a_mm=a, alpha_deg=alpha, d_mm=d, theta_deg=theta, limits_deg=limits
        )
        for number, ((a, alpha, d, theta), limits) in enumerate(rows, 1)
    ]
    if arm.flange_mm:
        joints[-1] = joints[-1].model_copy(update={"error": ErrorPart(z_mm=arm.flange_mm)})
    return ImportedArm(
        message("source-nominal-arm", name=name, source=arm.source),
        asked,
        name=name,
        convention=arm.convention,
        base=ErrorPart(rx_deg=arm.base_turn_x_deg) if arm.base_turn_x_deg else None,
        joints=tuple(joints),
        notes=(message("nominal-is-not-this-arm"),),
    )
