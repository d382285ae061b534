"""``crenel certificate``: Digital Calibration Certificates, read and written."""

from enum import StrEnum
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from crenel.console import AsJson, FullHelpGroup, print_figures, print_json, report_errors, warn
from crenel.gauges.command_line import Country, Laboratory, Schema, print_written
from crenel.messages.message import Text, message

if TYPE_CHECKING:
    from crenel.gauges.plan.document import SpherePart
    from crenel.gauges.plan.document_gauge import GaugeFile
    from crenel.gauges.plan.document_length_standard import LengthStandardFile

certificate = typer.Typer(
    cls=FullHelpGroup,
    help="Digital Calibration Certificates (DCC, version 3).",
    no_args_is_help=True,
)


class ArtefactKind(StrEnum):
    """What was calibrated."""

    SPHERE = "sphere"
    BALL_BAR = "ball-bar"
    STEP_GAUGE = "step-gauge"


@certificate.command()
@report_errors
def read(
    file: Annotated[Path, typer.Argument(help="The certificate, an XML file.")],
    kind: Annotated[ArtefactKind, typer.Option(help="What was calibrated.")] = ArtefactKind.SPHERE,
    output: Annotated[
        Path | None,
        typer.Option("-o", "--output", help="A sphere's gauge file, or a length standard's file."),
    ] = None,
    diameter: Annotated[
        str, typer.Option(help="Part of the diameter's name, if there are several.")
    ] = "",
    form: Annotated[str, typer.Option(help="Part of the form's name, if there are several.")] = "",
    length: Annotated[str, typer.Option(help="Part of the name of the lengths.")] = "",
    as_json: AsJson = False,
) -> None:
    """Read size, uncertainty and validity of a sphere or a length standard.

    A signature of the certificate is not checked.
    """
    from crenel.formats.atomic_write import check_output_path
    from crenel.gauges.exchange.read_certificate import (
        read_length_certificate,
        read_sphere_certificate,
    )

    document: GaugeFile | LengthStandardFile
    if kind is ArtefactKind.SPHERE:
        found = read_sphere_certificate(file, diameter, form)
        part: SpherePart | LengthStandardFile = found.sphere
        document, rows, spheres_known = found.gauge, _sphere_rows(found.sphere), True
    else:
        bar = kind is ArtefactKind.BALL_BAR
        standard = read_length_certificate(file, "ball-bar" if bar else "step-gauge", length)
        part = document = standard
        rows = _length_rows(standard)
        spheres_known = not bar or standard.sphere_diameter_mm is not None
    if not as_json:
        warn(message("expansion-not-read"))
        if not spheres_known:
            warn(message("sphere-diameter-not-read"))
    if output is not None:
        document.write(check_output_path(output, [file]))
    if as_json:
        print_json(part.model_dump(mode="json"))
        return
    print_figures(f"Certificate {file}", [*_artefact_rows(part), *rows])
    if output is not None:
        print(f"{output} written")


def _artefact_rows(part: "SpherePart | LengthStandardFile") -> list[tuple[Text, Text]]:
    return [
        ("Name", part.name),
        ("Serial number", part.serial_number or "–"),
        ("Certificate", part.certificate or "–"),
        ("Valid until", part.valid_until or "–"),
    ]


def _sphere_rows(sphere: "SpherePart") -> list[tuple[Text, Text]]:
    known = f"± {2 * sphere.diameter_sd_um:.2f} µm, k = 2"
    return [
        ("Diameter", f"{sphere.diameter_mm:.5f} mm {known}"),
        ("Form", f"{sphere.form_um:.2f} µm ± {2 * sphere.form_sd_um:.2f} µm, k = 2"),
    ]


def _length_rows(standard: "LengthStandardFile") -> list[tuple[Text, Text]]:
    return [
        (
            f"Length {number}",
            f"{one.length_mm:.5f} mm ± {2 * one.standard_uncertainty_um:.2f} µm, k = 2",
        )
        for number, one in enumerate(standard.lengths, 1)
    ]


@certificate.command()
@report_errors
def write(
    folder: Annotated[Path, typer.Argument(metavar="TEST", help="The folder of a test.")],
    output: Annotated[Path, typer.Option("-o", "--output", help="Where to write it.")] = Path(
        "performance-dcc.xml"
    ),
    laboratory: Laboratory = "",
    country: Country = "",
    customer: Annotated[
        str, typer.Option(help="For whom; by default, the laboratory itself.")
    ] = "",
    schema: Schema = None,
) -> None:
    """Write the certificate of a performance test, in English and German, without a signature."""
    from crenel.gauges.exchange.export import export_result
    from crenel.gauges.exchange.write_certificate import Issuer
    from crenel.gauges.judgement.document import read_performance

    document = read_performance(folder)
    issuer = Issuer(laboratory or document.station, country, customer)
    written, warnings = export_result(document, "dcc", output, issuer, schema)
    print_written(written, warnings, schema)


@certificate.command()
@report_errors
def block(
    drawing: Annotated[
        Path, typer.Option(help="object.json of the block as drawn, with tolerance_mm.")
    ],
    readings: Annotated[
        Path | None,
        typer.Argument(metavar="[READINGS]", help="Distances of faces, a CSV table."),
    ] = None,
    points: Annotated[
        Path | None,
        typer.Option(help="Touches of faces, a CSV table, or a session's folder."),
    ] = None,
    arm: Annotated[
        Path | None, typer.Option(help="arm.json of the arm whose joint angles the touches are.")
    ] = None,
    arm_um: Annotated[
        float | None,
        typer.Option(
            min=0.0, help="Rms error of its tip over the reach; by default, as identified."
        ),
    ] = None,
    tip_um: Annotated[
        float | None,
        typer.Option(
            min=0.0, help="Standard uncertainty of the tip's diameter; by default, unknown."
        ),
    ] = None,
    output: Annotated[
        Path, typer.Option("-o", "--output", help="Where to write object.json.")
    ] = Path("object.json"),
    page: Annotated[
        Path | None, typer.Option(help="Where to write the page, as .html or .pdf.")
    ] = None,
    issued: Annotated[str, typer.Option(help="Who certifies it and when, for reports.")] = "",
    language: Annotated[str, typer.Option(help="Of the page.")] = "en",
    as_json: AsJson = False,
) -> None:
    """Certify a block from readings of its widths and heights, and from touches of its faces.

    Readings are by calliper, micrometer or tip, touches by a coordinate measuring machine or an
    arm.
    """
    from crenel.formats.atomic_write import check_output_path, write_atomically
    from crenel.formats.certifying.block_certificate import certify_block
    from crenel.formats.certifying.block_points import read_touching_arm, session_files
    from crenel.report.contents.block_certificate import block_certificate_report
    from crenel.report.contents.reports import render
    from crenel.timestamps import utc_now

    if points is not None and points.is_dir():
        of_session, points = session_files(points)
        arm = arm or of_session
    by = None if arm is None else read_touching_arm(arm, arm_um, tip_um)
    made = certify_block(drawing, readings, issued, points, by)
    inputs = [one for one in (readings, points, arm) if one is not None]
    target = check_output_path(output, inputs)
    if page is not None:
        content = render(block_certificate_report(made, utc_now()), page.suffix, language)
        write_atomically(check_output_path(page, [*inputs, drawing]), content)
    made.document.write(target)
    if as_json:
        print_json(made.document.model_dump(mode="json", exclude_none=True))
        return
    each = made.document.standard_uncertainties_mm
    assert each is not None
    edges = zip(made.document.edges_x_mm, each.edges_x_mm, strict=True)
    print_figures(
        f"Certificate of {made.document.name}",
        [
            *(
                (f"edge_{number}", f"{x:.4f} mm ± {2e3 * sd:.1f} µm, k = 2")
                for number, (x, sd) in enumerate(edges, 1)
            ),
            *(
                (message("tool-zero-or-diameter", tool=tool), f"{value:.4f} mm")
                for tool, (value, _) in made.fit.tools.items()
            ),
        ],
    )
    print(f"{output} written")
