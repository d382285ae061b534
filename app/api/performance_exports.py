"""Results of performance tests as files for other programs; nothing of them is stored."""

import asyncio
import io
import tempfile
import zipfile
from pathlib import Path
from typing import Literal

from fastapi import APIRouter
from starlette.responses import Response

from app.api.lookups import find_performance
from app.formats.exchange.export import export_result
from app.formats.open_file import read_bounded
from app.formats.performance.results import read_performance
from app.operations.context import TheContext

router = APIRouter(prefix="/api")
Form = Literal["zip", "xlsx", "qif"]
MEDIA: dict[Form, str] = {
    "zip": "application/zip",
    "xlsx": "application/octet-stream",
    "qif": "application/xml",
}


@router.get("/performances/{record_id}/export.{form}")
async def performance_export(record_id: str, form: Form, context: TheContext) -> Response:
    """The result as CSV tables in a zip file, as a workbook, or as QIF."""
    folder = find_performance(context, record_id).folder
    content = await asyncio.to_thread(_export_bytes, folder, form)
    named = {"Content-Disposition": f'attachment; filename="performance-{record_id}.{form}"'}
    return Response(content, media_type=MEDIA[form], headers=named)


def _export_bytes(folder: Path, form: Form) -> bytes:
    """The file; raises ``OperationError`` if the result cannot be read or an extra is missing."""
    document = read_performance(folder)
    with tempfile.TemporaryDirectory() as place:
        output = Path(place) / f"performance.{form}"
        if form != "zip":
            export_result(document, form, output)
            return read_bounded(output)
        written, _ = export_result(document, "csv", Path(place) / "tables")
        packed = io.BytesIO()
        with zipfile.ZipFile(packed, "w", zipfile.ZIP_DEFLATED) as archive:
            for path in written:
                archive.write(path, path.name)
        return packed.getvalue()
