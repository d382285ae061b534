"""Datasheets of the station: listed, checked, added, retired and brought back."""

from typing import Annotated

from pydantic import Field
from starlette.requests import Request
from starlette.responses import Response

from crenel.api.access.authorization import StationRouter
from crenel.api.answers.lookups import send_file
from crenel.messages.message import message
from crenel.operations.context import TheContext
from crenel.operations.datasheets.arm_models import ArmModelView, view_model
from crenel.operations.datasheets.documents import FOLDERS, DatasheetKind
from crenel.operations.datasheets.view import (
    DatasheetCheck,
    DatasheetRow,
    DatasheetsView,
    JointsView,
)
from crenel.wire.schema import RequestBody

router = StationRouter(prefix="/api/datasheets")

FileName = Annotated[str, Field(max_length=255)]
Version = Annotated[str, Field(max_length=64)]


class DatasheetDocument(RequestBody):
    """A file as it is, or what was entered into a form."""

    name: Annotated[str, Field(max_length=200)] = ""
    """The name of the file; empty for a form."""
    text: str


class ModelText(RequestBody):
    """A text with the model of an arm, pasted or of a file."""

    text: str
    answers: dict[Annotated[str, Field(max_length=40)], Annotated[str, Field(max_length=200)]] = (
        Field(default={}, max_length=20)
    )
    """What the person said so far, by the keys of the questions."""


class AddedDatasheet(DatasheetDocument):
    """A document to be kept."""

    replace: bool = False
    """Another datasheet of the same thing is retired."""
    edited: Version = ""
    """The version that was edited, which is retired."""


class NamedDatasheet(RequestBody):
    """One of the list."""

    kind: DatasheetKind
    file: FileName
    version: Version


class RetiredDatasheet(NamedDatasheet):
    """A retired one that is to be used again."""

    replace: bool = False


@router.get("")
def datasheets(context: TheContext) -> DatasheetsView:
    """All datasheets, those in use and the retired ones."""
    return context.datasheets.view()


@router.get("/joints")
def joints(context: TheContext) -> JointsView:
    """How the joints of the connected arm stand, which turn its drawing."""
    return context.datasheets.joints()


@router.post("")
def add(asked: AddedDatasheet, context: TheContext, request: Request) -> DatasheetRow:
    """Keeps a datasheet or a certificate that can be evaluated. One of the same thing is asked
    about, and then retired."""
    request.state.detail = asked.name
    added = context.datasheets.add(asked.name, asked.text, asked.replace, asked.edited)
    request.state.detail = f"{FOLDERS[added.kind]}/{added.file}"
    return added


@router.post("/check")
def check(asked: DatasheetDocument, context: TheContext) -> DatasheetCheck:
    """Evaluates a document without keeping it."""
    return context.datasheets.check(asked.name, asked.text)


@router.post("/model")
def read_arm_model(asked: ModelText) -> ArmModelView:
    """Reads the model of an arm without keeping anything."""
    return view_model(asked.text, asked.answers)


@router.post("/retire")
def retire(asked: NamedDatasheet, context: TheContext, request: Request) -> DatasheetsView:
    """Takes a datasheet out of use; it is kept."""
    request.state.detail = f"{FOLDERS[asked.kind]}/{asked.file}"
    context.datasheets.retire(asked.kind, asked.file, asked.version)
    return context.datasheets.view()


@router.post("/restore")
def restore(asked: RetiredDatasheet, context: TheContext, request: Request) -> DatasheetsView:
    """Brings a retired datasheet back into use."""
    request.state.detail = f"{FOLDERS[asked.kind]}/{asked.file}"
    context.datasheets.restore(asked.kind, asked.file, asked.version, asked.replace)
    return context.datasheets.view()


@router.get("/{kind}/{file}")
def download(
    kind: DatasheetKind, file: FileName, context: TheContext, retired: bool = False
) -> Response:
    """The file itself, as described in docs/formats.md."""
    path = context.datasheets.path(kind, file, retired)
    media_type = "application/xml" if path.suffix == ".xml" else "application/json"
    return send_file(path, message("no-longer-in-data-folder", name=file), media_type, file)
