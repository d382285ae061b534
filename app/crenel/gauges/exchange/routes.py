"""Results of performance tests as files for other programs; nothing of them is stored."""

import asyncio
import io
import tempfile
import zipfile
from pathlib import Path
from typing import Annotated, Literal

from fastapi import Query
from starlette.responses import Response

from crenel.api.access.authorization import StationRouter
from crenel.api.answers.lookups import find_performance
from crenel.formats.exchange.write_tables import workbook_obstacle
from crenel.formats.open_file import read_bounded
from crenel.gauges.exchange.export import export_result
from crenel.gauges.exchange.write_certificate import Issuer
from crenel.gauges.judgement.document import read_performance
from crenel.operations.context import TheContext
from crenel.wire.schema import ExportFormats

router = StationRouter(prefix="/api")
Form = Literal["zip", "xlsx", "qif", "dcc"]
MEDIA: dict[Form, str] = {
    "zip": "application/zip",
    "xlsx": "application/octet-stream",
    "qif": "application/xml",
    "dcc": "application/xml",
}
ENDINGS: dict[Form, str] = {"zip": ".zip", "xlsx": ".xlsx", "qif": ".qif", "dcc": "-dcc.xml"}


@router.get("/export-formats")
def export_formats() -> ExportFormats:
    """Which formats this station can write."""
    return ExportFormats(xlsx_why_not=workbook_obstacle())


@router.get("/performances/{record_id}/export.{form}")
async def performance_export(
    record_id: str,
    form: Form,
    context: TheContext,
    laboratory: Annotated[str, Query(max_length=200)] = "",
    country: Annotated[str, Query(max_length=20)] = "",
) -> Response:
    """The result as CSV tables in a zip file, as a workbook, as QIF, or as DCC.

    ``laboratory`` (by default, the station) and ``country`` (two letters) issue a certificate.
    """
    folder = find_performance(context, record_id).folder
    content = await asyncio.to_thread(_export_bytes, folder, form, laboratory, country)
    name = f"performance-{record_id}{ENDINGS[form]}"
    named = {"Content-Disposition": f'attachment; filename="{name}"'}
    return Response(content, media_type=MEDIA[form], headers=named)


def _export_bytes(folder: Path, form: Form, laboratory: str, country: str) -> bytes:
    """The file.

    Raises:
        OperationError: the result cannot be read, an extra is missing, or the issuer.
    """
    document = read_performance(folder)
    with tempfile.TemporaryDirectory() as place:
        output = Path(place) / f"performance.{form}"
        if form != "zip":
            issuer = Issuer(laboratory or document.station, country)
            export_result(document, form, output, issuer)
            return read_bounded(output)
        written, _ = export_result(document, "csv", Path(place) / "tables")
        packed = io.BytesIO()
        with zipfile.ZipFile(packed, "w", zipfile.ZIP_DEFLATED) as archive:
            for path in written:
                archive.write(path, path.name)
        return packed.getvalue()
