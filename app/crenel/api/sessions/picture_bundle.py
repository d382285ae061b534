"""One pose's pictures with their context, so that somebody else can see why they were refused."""

import io
import json
import zipfile
from collections.abc import Mapping, Sequence

from pydantic_core import to_jsonable_python

from crenel.api.monitoring.support import context_redactor
from crenel.findings import Finding
from crenel.formats.images import read_grey
from crenel.formats.io_errors import convert_io_errors
from crenel.formats.open_file import read_bounded
from crenel.formats.session.calibration_session import OBJECT, SENSOR
from crenel.guide.calibration.outcome import CalibrationOutcome, from_payload
from crenel.guide.calibration.state import PoseCapture, SolveFailure
from crenel.messages.message import text_to_json
from crenel.monitoring.redaction import Redactor
from crenel.operations.context import Context
from crenel.operations.health_checks import software
from crenel.workflows.pictures.draw_pictures import draw_outcome, encode_drawing

README = """A picture that a Crenel station took for a calibration, and why it is in question.

*.png         the picture or pictures of the pose, as taken
found.png     the picture with what was found: corners green, stripe red, evidence orange
object.json   the object by its certificate
sensor.json   the sensor by its datasheet
context.json  findings with their message ids and values, exposure, the arm's angles, versions

Passwords, tokens, keys, addresses, people's names and folders of the station were taken out. Look
it over before you send it; nothing was sent anywhere.
"""


def bundle_picture(context: Context, capture: PoseCapture) -> bytes:
    """The bundle as a zip file.

    Raises:
        OperationError: a file of the session cannot be read.
    """
    folder = context.guide.folder.path
    outcome = from_payload(capture.outcome)
    state = context.guide.state
    refused = state.refused if state.refused and state.refused.inputs == state.inputs else None
    described = _redact(
        context_redactor(context),
        {
            "software": software(context),
            **_describe_capture(capture),
            **_describe_outcome(outcome),
            "refused": None if refused is None else _describe_failure(refused),
        },
    )
    drawing = draw_outcome(
        read_grey(folder / capture.ambient),
        [(corner.u, corner.v) for corner in outcome.corners],
        outcome.stripe,
        [(mark.u0, mark.v0, mark.u1, mark.v1) for mark in outcome.marks],
    )
    packed = io.BytesIO()
    with convert_io_errors(folder), zipfile.ZipFile(packed, "w") as archive:
        archive.writestr("README.txt", README)
        archive.writestr("context.json", json.dumps(described, indent=1, ensure_ascii=False))
        for name in (OBJECT, SENSOR):
            archive.writestr(name, read_bounded(folder / name))
        for picture in (capture.ambient, capture.laser):
            if picture is not None:
                archive.writestr(picture.rsplit("/", 1)[-1], read_bounded(folder / picture))
        archive.writestr("found.png", encode_drawing(drawing))
    return packed.getvalue()


def _redact(redactor: Redactor, value: object, key: str = "") -> object:
    """A JSON value without secrets and names; ids of messages are none, long as they are."""
    if isinstance(value, Mapping):
        return {name: _redact(redactor, one, name) for name, one in value.items()}
    if isinstance(value, (list, tuple)):
        return [_redact(redactor, one, key) for one in value]
    return value if key == "message_id" else redactor.value(value, key)


def _describe_capture(capture: PoseCapture) -> dict[str, object]:
    return {
        "pose": capture.number,
        "lighting": capture.lighting,
        "exposure_us": capture.exposure_us,
        "width_px": capture.width_px,
        "height_px": capture.height_px,
        "reading": list(capture.reading),
    }


def _describe_outcome(outcome: CalibrationOutcome) -> dict[str, object]:
    return {
        "fault": outcome.fault,
        "findings": _describe_findings(outcome.findings),
        "corners": [(one.name, one.u, one.v) for one in outcome.corners],
        "outline": list(outcome.outline),
        "marks": to_jsonable_python(outcome.marks),
    }


def _describe_findings(findings: Sequence[Finding]) -> list[dict[str, object]]:
    """Each in English, and as the message with its values."""
    return [
        {
            "quality": one.quality,
            "text": str(one.text),
            "text_message": text_to_json(one.text),
            "remedy": str(one.remedy),
            "remedy_message": text_to_json(one.remedy),
        }
        for one in findings
    ]


def _describe_failure(refused: SolveFailure) -> dict[str, object]:
    error = refused.error
    return {
        "code": error.code,
        "text": str(error.reason),
        "what": text_to_json(error.what),
        "why": text_to_json(error.why),
        "remedy": text_to_json(error.remedy),
    }
