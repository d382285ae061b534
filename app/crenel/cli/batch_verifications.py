"""The command line's part for verifications in archives, measured again: ``crenel verify`` and
``study``; ``crenel drift`` measures with it, too."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

import typer

from crenel.cli.batch import Tally, do_missing, open_places, output_settings, say, selection_of
from crenel.cli.batch_options import BatchOptions
from crenel.cli.choice import count_words, fail_without_verifications
from crenel.console import print_json, print_table, progress_bar

if TYPE_CHECKING:
    from crenel.batch.places import Place
    from crenel.batch.results import ResultStore
    from crenel.batch.verifications import VerificationTask
    from crenel.gauges.plan.document_gauge import Shape

TABLE = "table.csv"
MOST_ROWS = 200
"""Printed; the table in the output has all."""


def measure_places(
    kind: str,
    places: Sequence[str],
    calibrations: Sequence[str],
    arm: Path | None,
    shape: "Shape | None",
    options: BatchOptions,
) -> None:
    """Measures the clouds of all chosen verifications, prints the table and writes it.

    Args:
        kind: ``verify``: with the calibration that was verified; ``study``: with all of the
            station; each with ``calibrations`` instead, if there are any.
    """
    from crenel.batch.verifications import COLUMNS, table_of, table_text, table_with_uncertainties

    done = measure_verifications(kind, places, calibrations, arm, shape, options)
    rows = table_of(done.documents)
    done.results.write_table(TABLE, table_text(rows))
    if options.as_json:
        print_json(
            {
                "made": len(done.tally.done),
                "already_there": done.known,
                "rows": [dict(zip(COLUMNS, row, strict=True)) for row in rows],
                "refused": {name: refusal.error().line for name, refusal in done.tally.refused},
                "output": done.results.settings.place,
            }
        )
    else:
        title = count_words(len(done.documents), "verification")
        print_table(title, *table_with_uncertainties(rows[:MOST_ROWS]))
        place = done.results.settings.place.rstrip("/")
        are = "is" if len(rows) == 1 else "are"
        print(f"{count_words(len(rows), 'row')} {are} in {place}/{TABLE}")
    done.tally.end(done.known)


@dataclass(frozen=True)
class MeasuredVerifications:
    """The verifications of some places, measured again."""

    places: "Sequence[Place]"
    documents: "Sequence[tuple[VerificationTask, Mapping[str, Any]]]"
    """Each that was not refused, with the fields of its ``crenel/study`` document."""
    results: "ResultStore"
    known: int
    """That had a result before."""
    tally: Tally


def measure_verifications(
    kind: str,
    places: Sequence[str],
    calibrations: Sequence[str],
    arm: Path | None,
    shape: "Shape | None",
    options: BatchOptions,
) -> MeasuredVerifications:
    """Measures the clouds of all chosen verifications that have no result yet.

    Args:
        kind: as of ``measure_places``, or ``drift``: with the calibration that was verified.
    """
    from crenel.batch.calibrations import CalibrationFinder, choose_calibration
    from crenel.batch.patience import Patience
    from crenel.batch.results import ResultStore
    from crenel.batch.verifications import plan_verifications

    if arm is not None and not calibrations:
        raise typer.BadParameter("needs a calibration, too", param_hint="'--arm'")
    patience = Patience(say)
    found, keys = open_places(places, options.config, patience)
    results = ResultStore(output_settings(options.output, keys, found), patience)
    results.prepare()
    finder = CalibrationFinder(found, patience)
    given = tuple(choose_calibration(one, arm, finder) for one in calibrations)
    selection = selection_of(found, options.period, options.station, options.taken_with)
    with progress_bar("Looking for verifications", not options.as_json) as progress:
        tasks, refused = plan_verifications(
            found,
            selection,
            results.settings,
            given or ("all" if kind == "study" else "own"),
            shape,
            progress,
            patience,
        )
    if not (tasks or refused):
        fail_without_verifications(found, shape, patience)
    tally = Tally(refused=refused)
    known = do_missing(
        kind, tasks, results, options.workers, options.scheduler, tally, options.as_json
    )
    refused_names = {name for name, _ in tally.refused}
    documents = [
        (task, read)
        for task in tasks
        if task.name not in refused_names and (read := results.read(task.stem)) is not None
    ]
    return MeasuredVerifications(found, documents, results, known, tally)
