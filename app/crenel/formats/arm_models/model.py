"""What a reader of arm models returns: joints, or the questions that are open."""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, Literal

from crenel.errors import OperationError
from crenel.formats.datasheets.arm import ArmFile, ErrorPart, JointPart
from crenel.messages.message import Text, message

QuestionKey = Literal["columns", "length", "angle", "convention", "end", "base", "robot"]
Answers = Mapping[str, str]
"""What a person said, by the key of the question."""
LIMIT_DEG = 180.0
"""Limits of a joint of which nothing is said: those of a new row of the form."""


@dataclass(frozen=True)
class ModelQuestion:
    """Something that decides what a text means."""

    key: QuestionKey
    options: tuple[str, ...]
    answer: str = ""
    """What the person said, or the text itself; empty while it is open."""
    stated: bool = False
    """The text itself says it: the person sees it, and need not answer."""
    likely: str = ""
    """What the numbers let expect; empty if nothing."""
    why: Text = ""
    """Why that is likely."""


@dataclass(frozen=True)
class ImportedArm:
    """An arm as its text gives it, in mm and degrees."""

    source: Text
    """What the text was recognized as."""
    questions: tuple[ModelQuestion, ...]
    name: str = ""
    convention: Literal["dh-standard", "dh-modified"] = "dh-standard"
    base: ErrorPart | None = None
    joints: tuple[JointPart, ...] = ()
    """Empty while a question is open."""
    notes: tuple[Text, ...] = ()
    """What the person should know: what was left out or put in."""

    @property
    def is_open(self) -> bool:
        """Whether a question has no answer yet."""
        return not self.joints

    def fields(self) -> dict[str, Any]:
        """The fields of ``arm.json`` that the model has: all but serial number and tip."""
        return {
            "format": ArmFile.FORMAT,
            "version": ArmFile.VERSION,
            "name": self.name,
            "convention": self.convention,
            **({} if self.base is None else {"base": self.base.model_dump()}),
            "joints": [joint.model_dump(mode="json", exclude_none=True) for joint in self.joints],
        }


def answer_to(question: ModelQuestion, answers: Answers) -> str:
    """The person's answer to a question that the text leaves open; empty if there is none.

    Raises:
        OperationError: it is none of the options.
    """
    answer = answers.get(question.key, "")
    if answer and answer not in question.options:
        raise OperationError(
            "model-answer-unknown",
            message("model-answer-unknown", key=question.key, answer=repr(answer)),
            remedy=message("give-one-of", names=", ".join(question.options)),
        )
    return answer
