"""``crenel performance``: performance tests of an arm and its scanner."""

from pathlib import Path
from typing import Annotated

import typer

from app.console import AsJson, FullHelpGroup, print_figures, print_json, report_errors, warn

performance = typer.Typer(
    cls=FullHelpGroup,
    help="Performance tests after ISO 10360-8/-12 and ASME B89.4.22.",
    no_args_is_help=True,
)


@performance.callback()
def group() -> None:
    """Keeps ``evaluate`` a command of its own while it is the only one."""


@performance.command()
@report_errors
def evaluate(
    folder: Annotated[Path, typer.Argument(metavar="TEST", help="The folder of a test.")],
    as_json: AsJson = False,
) -> None:
    """Compute every figure of a test from its touches and recordings; writes performance.json."""
    from app.workflows.performance.evaluate import write_performance

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
        why = f" ({figure.problem})" if figure.problem else ""
        rows.append((figure.symbol, f"{value}{limit}{why}"))
    print_figures(f"Performance test {result.id}", rows)
    for text in (result.status, result.offset.text if result.offset else "", result.verdict.text):
        if text:
            print(text)
