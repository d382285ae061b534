"""The command line's part for the verifications in archives: ``crenel verify`` and ``study``."""

from collections.abc import Sequence
from pathlib import Path

import typer

from app.cli.batch import Tally, do_missing, open_places, output_settings, selection_of
from app.cli.batch_options import BatchOptions
from app.console import print_json, print_table, progress_bar
from app.formats.datasheets.gauge import Shape

TABLE = "table.csv"
MOST_ROWS = 200
"""Printed; the table in the output has all."""


def measure_places(
    kind: str,
    places: Sequence[str],
    calibrations: Sequence[str],
    arm: Path | None,
    shape: Shape | None,
    options: BatchOptions,
) -> None:
    """Measures the clouds of all chosen verifications, prints the table and writes it.

    Args:
        kind: ``verify``: with the calibration that was verified; ``study``: with all of the
            station; each with ``calibrations`` instead, if there are any.
    """
    from app.batch.calibrations import CalibrationFinder, choose_calibration
    from app.batch.results import ResultStore
    from app.batch.verifications import (
        COLUMNS,
        VerificationTask,
        plan_verifications,
        table_of,
        table_text,
    )

    if arm is not None and not calibrations:
        raise typer.BadParameter("needs a calibration, too", param_hint="'--arm'")
    found, keys = open_places(places, options.config)
    results = ResultStore(output_settings(options.output, keys, found))
    results.prepare()
    finder = CalibrationFinder(found)
    given = tuple(choose_calibration(one, arm, finder) for one in calibrations)
    with progress_bar("Looking for verifications", not options.as_json) as progress:
        tasks, refused = plan_verifications(
            found,
            selection_of(options.period, options.station, options.taken_with),
            results.settings,
            given or ("own" if kind == "verify" else "all"),
            shape,
            progress,
        )
    tally = Tally(refused=refused)
    known = do_missing(
        kind, tasks, results, options.workers, options.scheduler, tally, options.as_json
    )
    refused_names = {name for name, _ in tally.refused}
    documents: list[tuple[VerificationTask, dict[str, object]]] = []
    for task in tasks:
        if task.name not in refused_names and (read := results.read(task.stem)) is not None:
            documents.append((task, read))
    rows = table_of(documents)
    results.write_table(TABLE, table_text(rows))
    if options.as_json:
        print_json(
            {
                "made": len(tally.done),
                "already_there": known,
                "rows": [dict(zip(COLUMNS, row, strict=True)) for row in rows],
                "refused": {name: refusal.error().line for name, refusal in tally.refused},
                "output": results.settings.place,
            }
        )
    else:
        print_table(f"{len(tasks)} verifications", COLUMNS, rows[:MOST_ROWS])
        print(f"{len(rows)} rows are in {results.settings.place.rstrip('/')}/{TABLE}")
    tally.end()
