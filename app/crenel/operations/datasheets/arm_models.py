"""The model of an arm that a person pastes or drops: what is open, and what it then is."""

import json
from collections.abc import Mapping
from dataclasses import dataclass

from crenel.errors import OperationError
from crenel.formats.arm_models.import_model import read_model
from crenel.formats.arm_models.model import ModelQuestion
from crenel.messages.message import Text


@dataclass(frozen=True)
class ModelRow:
    """A joint as it would be taken over."""

    name: str
    a_mm: float
    alpha_deg: float
    d_mm: float
    theta_deg: float


@dataclass(frozen=True)
class ArmModelView:
    """What a text with a model of an arm means so far."""

    source: Text
    """What it was recognized as; empty if it is refused."""
    problem: Text
    """Why it is refused; empty if it is not."""
    questions: tuple[ModelQuestion, ...]
    notes: tuple[Text, ...]
    rows: tuple[ModelRow, ...]
    """Empty while a question is open."""
    document: str
    """``arm.json`` without the tip; empty while a question is open."""


def view_model(text: str, answers: Mapping[str, str]) -> ArmModelView:
    """Reads the model of an arm without keeping anything.

    Args:
        text: pasted, or of a file.
        answers: what the person said so far, by the keys of the questions.
    """
    try:
        model = read_model(text, answers)
    except OperationError as error:
        return ArmModelView("", error.text, (), (), (), "")
    if model.is_open:
        return ArmModelView(model.source, "", model.questions, model.notes, (), "")
    rows = tuple(
        ModelRow(joint.name, joint.a_mm, joint.alpha_deg, joint.d_mm, joint.theta_deg)
        for joint in model.joints
    )
    return ArmModelView(
        model.source, "", model.questions, model.notes, rows, json.dumps(model.fields())
    )
