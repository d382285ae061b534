"""The browser's types and the server's shapes are the same."""

import re
import types
from dataclasses import fields, is_dataclass
from pathlib import Path
from typing import Literal, Union, get_args, get_origin, get_type_hints

import pytest
from pydantic import BaseModel

from app import findings
from app.guide.common import result_view, view
from app.guide.common import validity as due
from app.messages.message import Text
from app.messages.stored import SUFFIX
from app.metrology.detection import failure_evidence as evidence
from app.server import live_replay as replay
from app.station import control_lease as lease
from app.station import operator_settings
from app.station import working_distance as distance_band
from app.station.devices import link_state as device_state
from app.station.devices import rig
from app.station.preview import capture_aids as aids
from app.station.preview import preview
from app.store import audit
from app.wire import readiness, schema

API = Path(__file__).resolve().parents[2] / "frontend/src/api"
SUBJECTS = ("access", "device", "flow", "home", "live", "record", "result", "scan", "settings")
TYPES = (API / "types.ts", *(API / f"{subject}Types.ts" for subject in SUBJECTS))
SHAPES: dict[str, type] = {
    "LiveNumber": view.LiveNumber,
    "Finding": findings.Finding,
    "Action": view.Action,
    "Step": view.Step,
    "BlockGeometry": view.BlockGeometry,
    "BoardGeometry": view.BoardGeometry,
    "TouchedPoint": view.TouchedPoint,
    "FaceProgress": view.FaceProgress,
    "ChoiceOption": view.ChoiceOption,
    "Choice": view.Choice,
    "DeviceLine": view.DeviceLine,
    "ImageCorner": view.ImageCorner,
    "ImageMark": evidence.ImageAnnotation,
    "BudgetRow": result_view.BudgetLine,
    "FaceResult": result_view.FaceResult,
    "WorstPoint": result_view.WorstPointLine,
    "MovedPoint": result_view.MovedPoint,
    "Comparison": result_view.Comparison,
    "CalibrationResult": result_view.CalibrationResult,
    "PlaneKnown": result_view.PlaneKnown,
    "MapPoint": result_view.MapPoint,
    "PoseRow": result_view.PoseRow,
    "PosePicture": view.PosePicture,
    "FlowView": view.FlowView,
    "FlowCommand": schema.FlowCommand,
    "Problem": schema.Problem,
    "DeviceState": device_state.DeviceState,
    "Devices": rig.Devices,
    "ScanState": schema.ScanStatus,
    "ReplayState": replay.ReplayState,
    "Delay": operator_settings.Delay,
    "StationSettings": operator_settings.StationSettings,
    "CalibrationSummary": schema.CalibrationSummary,
    "ScanSummary": schema.ScanSummary,
    "Station": schema.StationInfo,
    "Home": schema.Home,
    "Validity": due.Validity,
    "Next": due.NextAction,
    "PreviewHeader": preview.PreviewHeader,
    "You": schema.CurrentUser,
    "Session": schema.SignInState,
    "Readiness": readiness.Readiness,
    "Person": lease.Person,
    "Control": lease.Control,
    "Account": schema.AccountSummary,
    "Wall": schema.KioskLinkSummary,
    "AuditEntry": audit.AuditEntry,
    "Band": distance_band.Band,
    "Aid": aids.CaptureAid,
    "RecordedCalibration": schema.RecordedCalibration,
    "CalibrationPoint": schema.CalibrationPoint,
}
PICTURES = {
    "devices": view.DevicesPicture,
    "choices": view.ChoicesPicture,
    "object": view.ObjectPicture,
    "camera": view.CameraPicture,
    "still": view.StillPicture,
    "result": view.ResultPicture,
}


def source() -> str:
    text = re.sub(r"/\*.*?\*/", "", "".join(path.read_text() for path in TYPES), flags=re.S)
    return re.sub(r"//.*", "", text)


def interfaces() -> dict[str, str]:
    """The body of each exported interface."""
    found = {}
    for match in re.finditer(r"export interface (\w+) \{", source()):
        found[match[1]] = body_from(source(), match.end())
    return found


def body_from(text: str, start: int) -> str:
    depth, end = 1, start
    while depth:
        depth += {"{": 1, "}": -1}.get(text[end], 0)
        end += 1
    return text[start : end - 1]


def members(body: str) -> dict[str, str]:
    """Field names with their types; what is nested in braces is left as it is."""
    parts, depth, part = [], 0, ""
    for char in body:
        depth += {"{": 1, "}": -1}.get(char, 0)
        if char == ";" and depth == 0:
            parts.append(part)
            part = ""
        else:
            part += char
    parts.append(part)
    named = [re.match(r"\s*(\w+)(\??):\s*(.+)", p, flags=re.S) for p in parts]
    return {m[1]: m[3].strip() + (" | undefined" if m[2] else "") for m in named if m}


def kind_of(hint: object) -> set[str]:
    """The primitive kinds that a Python type is sent as; nested shapes are 'object'."""
    origin = get_origin(hint)
    if hint == Text or hint == Text | None:
        # the browser has put it into words
        return {"string"} if hint == Text else {"string", "null"}
    if origin in (Union, types.UnionType):
        return set().union(*(kind_of(arg) for arg in get_args(hint)))
    if origin is Literal or hint is str:
        return {"string"}
    if hint is bool:
        return {"boolean"}
    if hint in (int, float):
        return {"number"}
    if hint is type(None):
        return {"null"}
    if origin is not None and "Mapping" not in str(origin) and origin is not dict:
        return {"array"}
    return {"object"}


def kind_in_types(text: str) -> set[str]:
    """The same, of a TypeScript type."""
    text = re.sub(r"\{.*\}", "object", text.strip(), flags=re.S)
    kinds = set()
    for part in (p.strip() for p in text.split("|")):
        if part.endswith("[]") or part.startswith("[") or part == "Vec3":
            kinds.add("array")
        elif part in ("number", "string", "boolean", "null"):
            kinds.add(part)
        elif part == "undefined":
            kinds.add("null")
        elif part.startswith('"') or part in ("Quality", "Role", "WorkPage"):
            kinds.add("string")
        else:
            kinds.add("object")
    return kinds


def hints_of(shape: type) -> dict[str, object]:
    if is_dataclass(shape):
        # the browser puts a problem's messages in the place of its English
        names = [field.name for field in fields(shape) if field.type is not schema.ProblemMessages]
    else:
        assert issubclass(shape, BaseModel)
        # a payload's texts are sent as their messages where it has them
        names = [name for name in shape.model_fields if not name.endswith(SUFFIX)]
    hints = get_type_hints(shape)
    return {name: hints[name] for name in names}


def assert_same(shape: type, body: str) -> None:
    there, here = members(body), hints_of(shape)
    assert set(there) == set(here), shape.__name__
    for name, hint in here.items():
        assert kind_of(hint) == kind_in_types(there[name]), f"{shape.__name__}.{name}"


def test_every_interface_has_its_shape() -> None:
    assert set(interfaces()) == set(SHAPES)


@pytest.mark.parametrize("name", SHAPES)
def test_a_shape_has_the_fields_of_its_interface(name: str) -> None:
    assert_same(SHAPES[name], interfaces()[name])


@pytest.mark.parametrize("kind", PICTURES)
def test_a_picture_has_the_fields_of_its_variant(kind: str) -> None:
    text = source()
    union = text[text.index("export type Picture") :]
    start = union.index(f'{{ kind: "{kind}"') if f'{{ kind: "{kind}"' in union else -1
    if start < 0:
        found = re.search(rf'\{{\s*kind: "{kind}"', union)
        assert found is not None
        start = found.start()
    assert_same(PICTURES[kind], body_from(union, start + 1))


def test_a_live_request_is_what_the_browser_sends() -> None:
    text = source()
    union = text[text.index("export type LiveRequest") :]
    for shape, kind in (
        (schema.PreviewRequest, "preview"),
        (schema.PreviewAck, "preview_ack"),
        (schema.StationsRequest, "stations"),
    ):
        start = union.index(f'{{ type: "{kind}"')
        assert_same(shape, body_from(union, start + 1))


def test_this_check_sees_a_difference() -> None:
    with pytest.raises(AssertionError):
        assert_same(view.Step, "id: string; title: string;")
    with pytest.raises(AssertionError):
        assert_same(
            result_view.Comparison, "with_name: string; max_um: number | null; rms_um: number;"
        )
