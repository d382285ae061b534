"""The group ``python -m tests.bench``, and how its commands show what they measured."""

from collections.abc import Callable, Sequence
from dataclasses import asdict, dataclass
from typing import Any, TypeVar

import typer

from crenel.console import FullHelpGroup, print_json, print_table, progress_bar
from crenel.messages.message import Text
from crenel.progress import Progress

bench = typer.Typer(
    help="Measure the figures of docs/accuracy.md on this machine.",
    cls=FullHelpGroup,
    rich_markup_mode=None,
    no_args_is_help=True,
)

T = TypeVar("T")


@dataclass(frozen=True)
class Shown:
    """What a measurement is called while it runs, over its table, and in JSON."""

    work: str
    title: str
    key: str = ""
    """Of the list of its results; empty where it has one result, whose fields are the JSON."""


def measure(
    shown: Shown,
    as_json: bool,
    run: Callable[[Progress], T],
    columns: Sequence[Text],
    table: Callable[[T], Sequence[Sequence[Text]]],
) -> None:
    """Runs a measurement, and prints its results as JSON or as a table."""
    with progress_bar(shown.work, not as_json) as progress:
        results: Any = run(progress)
    if not as_json:
        print_table(shown.title, columns, table(results))
    elif shown.key:
        print_json({shown.key: [asdict(one) for one in results]})
    else:
        print_json(asdict(results))
