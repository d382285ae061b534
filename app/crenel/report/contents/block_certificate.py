"""The page of a block's certificate: its coordinates, and the readings that they rest on."""

from crenel.formats.certifying.block_certificate import BlockCertificate
from crenel.formats.certifying.block_points import face_label
from crenel.formats.certifying.block_readings import face_name
from crenel.formats.certifying.certificate_notes import certificate_notes
from crenel.formats.json_document import SOFTWARE
from crenel.messages.message import Text, message, quantity, signed
from crenel.metrology.calibration.observation_model import coordinates
from crenel.metrology.targets.block_readings import BlockReading
from crenel.report.content import (
    Facts,
    Report,
    ReportTable,
    Section,
    TextBlock,
    Verdict,
    signatures,
)
from crenel.report.formatting import UNKNOWN, device_name, format_moment, micrometres, software_name


def block_certificate_report(made: BlockCertificate, made_at: str) -> Report[Text]:
    """The certificate of a block, made ``at`` a moment in ISO 8601."""
    document = made.document
    largest = micrometres(1e3 * (document.standard_uncertainty_mm or 0.0))
    text = message("block-certified-by-readings", count=len(made.readings), largest=largest)
    if made.touches is not None:
        text = message(
            "block-certified-by-touches",
            touches=len(made.touches.rows),
            readings=len(made.readings),
            largest=largest,
        )
    return Report(
        title=message("block-certificate"),
        number=document.serial_number,
        station=document.certificate or UNKNOWN,
        date=format_moment(made_at),
        verdict=Verdict("good", message("readings-agree"), text),
        sections=[
            Section(message("object"), [_facts(made)]),
            Section(
                message("coordinates"),
                [_coordinates(made), *map(TextBlock, certificate_notes(made))],
            ),
            *_touches(made),
            *_readings(made),
            signatures(""),
        ],
    )


def _facts(made: BlockCertificate) -> Facts[Text]:
    document = made.document
    rows: list[tuple[Text, Text]] = [
        (message("object"), device_name(document.name, document.serial_number)),
        (message("certificate"), document.certificate or UNKNOWN),
    ]
    for tool, (value_mm, sd_mm) in made.fit.tools.items():
        known = micrometres(1e3 * sd_mm)
        found = message("tool-found", value=quantity(value_mm, "mm", 4), known=known)
        rows.append((message("tool-zero-or-diameter", tool=tool), found))
    rows.append((message("software"), software_name(SOFTWARE.version)))
    return Facts(rows)


def _coordinates(made: BlockCertificate) -> ReportTable[Text]:
    document, edges = made.document, len(made.document.edges_x_mm)
    each = document.standard_uncertainties_mm
    assert each is not None
    values = coordinates(document.block()).tolist()
    rows: list[tuple[Text, ...]] = [
        (face_name(face, edges), quantity(value, "mm", 4), micrometres(1e3 * sd))
        for face, (value, sd) in enumerate(zip(values, each.values_mm(), strict=True))
    ]
    columns = (message("face-of-block"), message("coordinate"), message("standard-uncertainty-k-1"))
    return ReportTable(columns, rows, (40, 30, 30))


def _touches(made: BlockCertificate) -> list[Section[Text]]:
    """The form of the faces, where they were touched."""
    if made.fit.touched is None:
        return []
    edges = len(made.document.edges_x_mm)

    def known(value_mm: float | None) -> Text:
        return UNKNOWN if value_mm is None else micrometres(1e3 * value_mm)

    rows: list[tuple[Text, ...]] = [
        (
            face_label(one.face, one.away, edges),
            str(one.touches),
            known(one.flatness_mm),
            known(one.out_of_parallel_mm),
        )
        for one in made.fit.touched.forms
    ]
    columns = (
        message("face-of-block"),
        message("touches-of-face"),
        message("flatness-of-touches"),
        message("out-of-parallel"),
    )
    table = ReportTable(columns, rows, (34, 18, 24, 24))
    note = TextBlock[Text](message("form-of-faces-is"))
    return [Section(message("faces-as-touched"), [table, note], together=False)]


def _readings(made: BlockCertificate) -> list[Section[Text]]:
    if not made.readings:
        return []
    edges = len(made.document.edges_x_mm)

    def row(number: int, one: BlockReading, off_mm: float) -> tuple[Text, ...]:
        first, second = face_name(one.first, edges), face_name(one.second, edges)
        return (
            message("reading-in-row", number=number, first=first, second=second),
            one.tool or UNKNOWN,
            quantity(one.distance_mm, "mm", 4),
            micrometres(1e3 * one.sd_mm),
            signed(1e3 * off_mm, "µm"),
        )

    rows = [
        row(number, one, float(off))
        for number, (one, off) in enumerate(
            zip(made.readings, made.fit.residuals_mm, strict=True), 1
        )
    ]
    columns = (
        message("reading-of-certificate"),
        message("tool-of-reading"),
        message("value"),
        message("standard-uncertainty-k-1"),
        message("reading-minus-fit"),
    )
    table = ReportTable(columns, rows, (36, 16, 18, 15, 15), numbers=2, small=True)
    return [Section(message("readings-of-certificate"), [table], together=False)]
