"""``crenel certificate``: Digital Calibration Certificates, read and written."""

from pathlib import Path
from typing import Annotated

import typer

from app.cli.performance import Country, Laboratory
from app.console import AsJson, FullHelpGroup, print_figures, print_json, report_errors, warn

certificate = typer.Typer(
    cls=FullHelpGroup,
    help="Digital Calibration Certificates (DCC, version 3).",
    no_args_is_help=True,
)


@certificate.command()
@report_errors
def read(
    file: Annotated[Path, typer.Argument(help="The certificate of a sphere, an XML file.")],
    output: Annotated[
        Path | None, typer.Option("-o", "--output", help="Write the sphere as a gauge's nominal.")
    ] = None,
    diameter: Annotated[
        str, typer.Option(help="Part of the diameter's name, if there are several.")
    ] = "",
    form: Annotated[str, typer.Option(help="Part of the form's name, if there are several.")] = "",
    as_json: AsJson = False,
) -> None:
    """Read diameter, form, uncertainty and validity of a sphere; -o writes gauge.nominal.json.

    A signature of the certificate is not checked.
    """
    from app.formats.atomic_write import check_output_path
    from app.formats.exchange.read_certificate import read_sphere_certificate

    found = read_sphere_certificate(file, diameter, form)
    sphere = found.sphere
    if output is not None:
        found.gauge.write(check_output_path(output, [file]))
    if as_json:
        print_json({"sphere": sphere.model_dump(), "laboratory": found.laboratory})
    else:
        known = f"± {2 * sphere.diameter_sd_um:.2f} µm, k = 2"
        rows = [
            ("Name", sphere.name),
            ("Serial number", sphere.serial_number or "–"),
            ("Certificate", sphere.certificate or "–"),
            ("Laboratory", found.laboratory or "–"),
            ("Calibrated on", found.calibrated_on or "–"),
            ("Valid until", sphere.valid_until or "–"),
            (
                "Diameter",
                f"{sphere.diameter_mm:.5f} mm {known}",
            ),
            ("Form", f"{sphere.form_um:.2f} µm ± {2 * sphere.form_sd_um:.2f} µm, k = 2"),
        ]
        print_figures(f"Certificate {file}", rows)
    if output is not None and not as_json:
        print(f"{output} written")


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
) -> None:
    """Write the certificate of a performance test, in English and German, without a signature."""
    from app.formats.exchange.export import export_result
    from app.formats.exchange.write_certificate import Issuer
    from app.formats.performance.results import read_performance

    document = read_performance(folder)
    issuer = Issuer(laboratory or document.station, country, customer)
    written, warnings = export_result(document, "dcc", output, issuer)
    for text in warnings:
        warn(text)
    for path in written:
        print(f"{path} written")
