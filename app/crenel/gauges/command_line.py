"""``crenel performance``: performance tests of an arm and its scanner."""

from enum import StrEnum
from pathlib import Path
from typing import Annotated

import typer

from crenel.console import AsJson, FullHelpGroup, print_figures, print_json, report_errors, warn
from crenel.messages.message import Text

Laboratory = Annotated[
    str, typer.Option(help="Of a certificate: who issues it; by default, the station.")
]
Country = Annotated[str, typer.Option(help="Of a certificate: two capital letters, such as DE.")]
Schema = Annotated[
    Path | None,
    typer.Option(
        metavar="FILE.xsd",
        help="Of QIF or a certificate: a schema that the file must comply with to be written.",
    ),
]

performance = typer.Typer(
    cls=FullHelpGroup,
    help="Performance tests after ISO 10360-8/-12 and ASME B89.4.22.",
    no_args_is_help=True,
)


@performance.command()
@report_errors
def evaluate(
    folder: Annotated[Path, typer.Argument(metavar="TEST", help="The folder of a test.")],
    as_json: AsJson = False,
) -> None:
    """Compute every figure of a test from its touches and recordings; writes performance.json."""
    from crenel.gauges.kinds import write_performance

    result = write_performance(folder)
    for problem in result.problems:
        warn(problem)
    if as_json:
        print_json(result.fields())
        return
    rows = []
    for figure in result.figures:
        value = "–" if figure.value is None else f"{figure.value:.1f} µm"
        limit = "" if figure.limit is None else f", limit {figure.limit:g} µm: {figure.decision}"
        why = f" ({figure.problem!s})" if figure.problem else ""
        rows.append((figure.symbol, f"{value}{limit}{why}"))
    print_figures(f"Performance test {result.id}", rows)
    for text in (result.status, result.offset.text if result.offset else "", result.verdict.text):
        if text:
            print(text)


class ExportFormat(StrEnum):
    """A format for other programs."""

    CSV = "csv"
    XLSX = "xlsx"
    QIF = "qif"
    DCC = "dcc"


@performance.command()
@report_errors
def export(
    folder: Annotated[Path, typer.Argument(metavar="TEST", help="The folder of a test.")],
    form: Annotated[ExportFormat, typer.Option("--format", help="Of the result.")],
    output: Annotated[
        Path | None,
        typer.Option("-o", "--output", help="Where to write it; of CSV, a folder."),
    ] = None,
    laboratory: Laboratory = "",
    country: Country = "",
    schema: Schema = None,
) -> None:
    """Write the result of a test for other programs: its figures, lengths, centres and places."""
    from crenel.gauges.exchange.export import export_result
    from crenel.gauges.exchange.write_certificate import Issuer
    from crenel.gauges.judgement.document import read_performance

    document = read_performance(folder)
    issuer = Issuer(laboratory or document.station, country)
    written, warnings = export_result(document, form.value, output, issuer, schema)
    print_written(written, warnings, schema)


def print_written(written: list[Path], warnings: list[Text], schema: Path | None) -> None:
    """Says what was written, and whether it was checked."""
    for text in warnings:
        warn(text)
    for path in written:
        print(f"{path} written" if schema is None else f"{path} written, valid by {schema}")
