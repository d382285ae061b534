"""A block's certificate from what a person measured, as ``crenel certificate block`` makes it.

Nothing of it is stored until its document is added to the datasheets.
"""

import asyncio
from typing import Annotated

from pydantic import Field
from starlette.responses import Response

from crenel.api.access.authorization import StationRouter
from crenel.api.datasheets.designs import Language, attachment
from crenel.api.datasheets.documents import FileName, Version
from crenel.formats.datasheets.target import Certificate
from crenel.operations.context import Context, TheContext
from crenel.operations.datasheets.block_measurements import (
    BlockCertificateView,
    BlockMeasurement,
    certify_measurement,
    view_certificate,
)
from crenel.report.contents.block_certificate import block_certificate_report
from crenel.report.contents.reports import render
from crenel.timestamps import utc_now
from crenel.wire.schema import RequestBody

router = StationRouter(prefix="/api/datasheets/block-certificate")

Micrometres = Annotated[float, Field(ge=0, le=1e4, allow_inf_nan=False)]


class MeasuredBlock(RequestBody):
    """The datasheet of a block, and what was measured of it."""

    file: FileName
    version: Version
    readings: str = ""
    """The table of ``readings.csv``; empty where there are none."""
    points: str = ""
    """The table of ``points.csv``, or of a session's contacts; empty where there are none."""
    certificate: Certificate = ""
    """Who certifies it."""
    arm: FileName = ""
    """The datasheet of the arm whose joint angles the points are."""
    arm_version: Version = ""
    arm_um: Micrometres | None = None
    """Rms error of its tip over the reach; None: as identified."""
    tip_um: Micrometres | None = None
    """Standard uncertainty of the tip's diameter; None: unknown."""


def _measurement(asked: MeasuredBlock, context: Context) -> BlockMeasurement:
    datasheets, arm = context.datasheets, None
    if asked.arm:
        arm = datasheets.path("arm", asked.arm, False, asked.arm_version)
    return BlockMeasurement(
        drawing=datasheets.path("object", asked.file, False, asked.version),
        readings=asked.readings,
        points=asked.points,
        certificate=asked.certificate,
        arm=arm,
        arm_um=asked.arm_um,
        tip_um=asked.tip_um,
    )


@router.post("")
def certify_block(asked: MeasuredBlock, context: TheContext) -> BlockCertificateView:
    """The faces of the block with their uncertainties, and its ``object.json``."""
    return view_certificate(certify_measurement(_measurement(asked, context)))


@router.post("/page")
async def certificate_page(
    asked: MeasuredBlock, context: TheContext, lang: Language = "en"
) -> Response:
    """The page of the certificate, as PDF."""
    measured = _measurement(asked, context)
    async with context.printer:
        content = await asyncio.to_thread(_page, measured, lang)
    return attachment(content, "application/pdf", "block-certificate.pdf")


def _page(measured: BlockMeasurement, language: str) -> bytes:
    report = block_certificate_report(certify_measurement(measured), utc_now())
    return render(report, ".pdf", language)
