"""The guided inspection, its programs, and the list of inspections."""

import tempfile
import zipfile
from pathlib import Path

from starlette.background import BackgroundTask
from starlette.responses import FileResponse, Response

from crenel.api.access.authorization import StationRouter
from crenel.api.answers.lookups import find_inspection, send_file
from crenel.api.sessions.routes import add_session_routes
from crenel.formats.io_errors import convert_io_errors
from crenel.messages.message import Text, message
from crenel.operations.context import Context, TheContext
from crenel.parts.session.commands import COMMANDS
from crenel.parts.session.picture import frame_text, name_part, result_view
from crenel.parts.session.programs import add_program
from crenel.parts.session.view import PartRecordView, PartView
from crenel.store.session_records import InspectionRecord
from crenel.wire.json_response import json_response
from crenel.wire.schema import InspectionSummary, UploadedProgram

router = StationRouter(prefix="/api")


add_session_routes(router, "/parts", PartView, lambda context: context.part_guide, COMMANDS)


@router.post("/parts/start", response_model=PartView)
def start(context: TheContext) -> Response:
    """Begins an inspection, or resumes the open one."""
    return json_response(context.part_guide.start())


@router.post("/parts/programs", response_model=PartView)
def upload_program(asked: UploadedProgram, context: TheContext) -> Response:
    """Keeps a program, once it is checked whole, and chooses it in an inspection that begins."""
    guide = context.part_guide
    added = add_program(context.store.folder, asked.name, asked.text)
    with guide.lock:
        guide.forget_datasheets()
        if guide.running and guide.state.step == "setup":
            guide.append("program_chosen", {"id": added})
        return json_response(guide.refresh())


@router.get("/parts/inspections")
def inspections(context: TheContext) -> list[InspectionSummary]:
    """Lists all finished inspections, newest first."""
    return [_summary(record) for record in context.store.inspections.all()]


@router.get("/parts/inspections/{inspection_id}")
def inspection(inspection_id: str, context: TheContext) -> Response:
    """The result of an inspection, as stored in its file."""
    from crenel.parts.document_results import RESULTS

    path = _folder_of(context, inspection_id) / RESULTS
    missing = message("inspection-result-missing")
    return send_file(path, missing, "application/json", f"results-{inspection_id}.json")


@router.get("/parts/inspections/{inspection_id}/view")
def inspection_view(inspection_id: str, context: TheContext) -> PartRecordView:
    """A finished inspection as the browser shows it."""
    from crenel.parts.document_program import PROGRAM, ProgramFile
    from crenel.parts.document_results import RESULTS, InspectionFile
    from crenel.parts.session.evaluate_so_far import frame_uncertainty

    record = find_inspection(context, inspection_id)
    found = InspectionFile.read(record.folder / RESULTS)
    frame: Text = ""
    if found.alignment is not None:
        program = ProgramFile.read(record.folder / PROGRAM)
        frame = frame_text(*frame_uncertainty(program, found.alignment))
    return PartRecordView(
        part=name_part(found.part or found.program, found.serial_number),
        ended_at=record.ended_at,
        operator=record.figures.operator,
        frame=frame,
        result=result_view(found),
    )


@router.get("/parts/inspections/{inspection_id}/folder.zip")
def inspection_folder(inspection_id: str, context: TheContext) -> Response:
    """The whole inspection folder: the command ``inspect`` finds the same by it."""
    folder = _folder_of(context, inspection_id)
    with tempfile.NamedTemporaryFile(suffix=".zip", delete=False) as made:
        packed = Path(made.name)
    try:
        with convert_io_errors(folder), zipfile.ZipFile(packed, "w", zipfile.ZIP_DEFLATED) as file:
            for path in sorted(one for one in folder.rglob("*") if one.is_file()):
                file.write(path, Path(f"inspection-{inspection_id}") / path.relative_to(folder))
    except BaseException:
        packed.unlink(missing_ok=True)
        raise
    return FileResponse(
        packed,
        media_type="application/zip",
        filename=f"inspection-{inspection_id}.zip",
        background=BackgroundTask(packed.unlink, missing_ok=True),
    )


def _folder_of(context: Context, inspection_id: str) -> Path:
    """The folder of a finished inspection, or of the one that is open."""
    guide = context.part_guide
    if guide.running and guide.state.session_id == inspection_id:
        return guide.folder
    return find_inspection(context, inspection_id).folder


def _summary(record: InspectionRecord) -> InspectionSummary:
    figures = record.figures
    return InspectionSummary(
        id=record.id,
        ended_at=record.ended_at,
        result=figures.result,
        text=figures.text,
        program=figures.program,
        part=figures.part,
        serial_number=figures.serial_number,
        passed=figures.passed,
        failed=figures.failed,
        undecided=figures.undecided,
        operator=figures.operator,
    )
