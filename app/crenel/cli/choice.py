"""What is asked for and is not there ends a command with what there is instead."""

from collections import Counter
from collections.abc import Iterable, Sequence, Set
from typing import TYPE_CHECKING, NoReturn

from crenel.console import fail
from crenel.progress import Progress

if TYPE_CHECKING:
    from crenel.batch.patience import Patience
    from crenel.batch.places import Place
    from crenel.batch.recordings import ScanRecording, Selection
    from crenel.gauges.plan.document_gauge import Shape

MOST_NAMED = 10
"""How many of the things that there are a message names."""


def count_words(count: int, noun: str) -> str:
    """A number with its noun.

    Example:
        >>> count_words(1, "record"), count_words(2, "record")
        ('1 record', '2 records')
    """
    return f"{count} {noun}" if count == 1 else f"{count} {noun}s"


def name_some(there: Iterable[str]) -> str:
    """The last ones of what there is, as a sentence."""
    names = sorted(set(there))
    if not names:
        return "There is none."
    more = f", and {len(names) - MOST_NAMED} more" if len(names) > MOST_NAMED else ""
    shown = ", ".join(names[-MOST_NAMED:])
    return f"There {'is' if len(names) == 1 else 'are'}: {shown}{more}."


def check_stations(asked: Iterable[str], there: Sequence[str], where: str) -> None:
    """Ends the command if one of the stations is not there.

    Args:
        where: as ``in these places``.
    """
    for one in asked:
        if one not in there:
            fail(f"there is no station {one} {where}. {name_some(there)}")


def check_found(
    selection: "Selection",
    places: "Sequence[Place]",
    found: "Sequence[ScanRecording]",
    patience: "Patience",
    progress: Progress,
) -> None:
    """Ends the command if a calibration, an id or a label that was asked for is of no recording.

    A calibration of the places with which nothing was recorded is no mistake.
    """
    from crenel.batch.recordings import Selection, find_recordings

    used = {one for recording in found for one in recording.calibration_ids.values()}
    calibrations = selection.taken_with - used
    if calibrations:
        kept = {one for place in places for one in place.ids("sessions", place.store(patience))}
        calibrations -= kept
    records = selection.records - {one.id for one in found}
    labels = selection.labels - {one.label for one in found}
    if not (calibrations or records or labels):
        return
    wider = Selection(selection.period, selection.stations)
    there = list(find_recordings(places, wider, progress, patience))
    chosen = "of these stations and this period"
    _check_names(f"no scan {chosen} has the id", records, {one.id for one in there})
    _check_names(f"no scan {chosen} has the label", labels, {one.label for one in there} - {""})
    used = {one for scan in there for one in scan.calibration_ids.values()} - {""}
    _check_names(f"no scan {chosen} was taken with", calibrations, used)
    asked = _join(records | labels | calibrations)
    fail(f"the options exclude one another: none of the scans that they leave is of {asked}.")


def _check_names(what: str, asked: Set[str], there: Set[str]) -> None:
    if missing := asked - there:
        fail(f"{what} {_join(missing)}. {name_some(there)}")


def count_scans(places: "Sequence[Place]") -> int:
    """How many scans the places have in all."""
    return sum(len(place.ids("scans", place.store())) for place in places)


def fail_without_verifications(
    places: "Sequence[Place]", shape: "Shape | None", patience: "Patience"
) -> NoReturn:
    """Ends the command, and says which verifications there are."""
    from crenel.batch.verifications import list_shapes

    shapes = Counter(list_shapes(places, patience))
    there = [f"{count} on a {one}" for one, count in sorted(shapes.items())]
    gauge = "" if shape is None else f" on a {shape}"
    fail(
        f"no verification{gauge} is chosen. The places have "
        f"{' and '.join(there) or 'none that is accepted'}."
    )


def _join(names: Iterable[str]) -> str:
    return ", ".join(sorted(names))
