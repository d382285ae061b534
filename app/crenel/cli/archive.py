"""``crenel archive``: what is in the archive of a station, and how it comes back."""

from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from crenel.cli.choice import count_words
from crenel.console import (
    AsJson,
    FullHelpGroup,
    fail,
    print_figures,
    print_json,
    progress_bar,
    report_errors,
    warn,
)

if TYPE_CHECKING:
    from crenel.archive.archive import Archive, ArchiveLook, ArchiveState
    from crenel.archive.manifest import Kind

archive = typer.Typer(
    cls=FullHelpGroup,
    help="The archive of a station: finished records, copied to another place and verified.",
    no_args_is_help=True,
)

Config = Annotated[
    Path | None, typer.Option("--config", help="station.toml with the table [archive].")
]
DataFolder = Annotated[
    Path | None, typer.Option("--data", help="Data folder of the station; it may be running.")
]
MOST_NAMES = 20
COPIED_AGAIN = "crenel archive run copies again what the station still has."


@archive.command()
@report_errors
def status(config: Config = None, data: DataFolder = None, as_json: AsJson = False) -> None:
    """Count what is archived and waiting, list what is in the archive only, name what it lacks.

    The archive is looked at by names and sizes of its files; verify reads all of it.
    """
    from dataclasses import asdict

    from crenel.archive.records import list_away
    from crenel.errors import OperationError

    with _open_archive(config, data) as opened:
        state, away = opened.state(), list_away(opened.data)
        place, look, problem = opened.settings.place, None, ""
        same_disk = opened.is_on_same_disk()
        try:
            look = opened.look()
        except OperationError as error:
            problem = error.line
    if as_json:
        listed = [{"kind": note.kind, "id": note.id, "bytes": note.size_bytes} for note in away]
        seen = {
            "look": asdict(look) if look is not None else None,
            "same_disk": same_disk,
            "problem": problem,
        }
        print_json({"place": place, **asdict(state), "in_archive_only": listed, **seen})
    else:
        _print_state(place, state, look)
        for note in away:
            print(f"{note.kind} {note.id}, {note.size_bytes / 1e6:.1f} MB")
        _warn_of_same_disk(opened)
    if look is None:
        fail(problem)
    if look.incomplete:
        names = _list_names(look.incomplete)
        fail(
            f"missing in {place}, or of another size: {names}. After crenel archive verify, "
            f"{COPIED_AGAIN}"
        )


def _list_names(names: Sequence[str]) -> str:
    rest = [f"{len(names) - MOST_NAMES} more"] if len(names) > MOST_NAMES else []
    return ", ".join([*names[:MOST_NAMES], *rest])


def _print_state(place: str, state: "ArchiveState", look: "ArchiveLook | None") -> None:
    rows = [
        ("waiting", f"{state.waiting}, {state.waiting_bytes / 1e6:.1f} MB"),
        ("archived and here", f"{state.archived}"),
        ("in the archive only", f"{state.away}"),
    ]
    if look is not None and look.read_at:
        rows.append(("every copy read there since", look.read_at))
    print_figures(place, rows)


@archive.command()
@report_errors
def run(config: Config = None, data: DataFolder = None) -> None:
    """Copy everything that is finished, then remove what the rules of retention let go."""
    with _open_archive(config, data) as opened, progress_bar("Archiving", True) as progress:
        copied = opened.run(progress)
        _warn_of_same_disk(opened)
    print(f"{count_words(copied, 'record')} copied to {opened.settings.place} and verified.")


def _warn_of_same_disk(opened: "Archive") -> None:
    from crenel.messages.message import message

    if opened.is_on_same_disk():
        warn(message("archive-on-same-disk", place=opened.settings.place))


@archive.command()
@report_errors
def verify(config: Config = None, data: DataFolder = None) -> None:
    """Read everything that the archive has of this station, and compare it by its hashes."""
    with _open_archive(config, data) as opened, progress_bar("Verifying", True) as progress:
        damaged = opened.verify(progress)
    if damaged:
        place = opened.settings.place
        fail(f"missing or damaged in {place}: {_list_names(damaged)}. {COPIED_AGAIN}")
    print(f"Everything in {opened.settings.place} is whole.")


@archive.command()
@report_errors
def fetch(
    kind: Annotated[
        str, typer.Argument(help="scans, verifications, performance or sessions.", metavar="KIND")
    ],
    record_id: Annotated[str, typer.Argument(help="Name of its folder.", metavar="ID")],
    config: Config = None,
    data: DataFolder = None,
) -> None:
    """Bring a record back to the station's disk, compared by its hashes."""
    with _open_archive(config, data) as opened:
        made = opened.fetch(_kind(kind), _id(record_id))
    files = count_words(len(made.files), "file")
    print(f"{kind}/{record_id}: {files}, {made.size_bytes / 1e6:.1f} MB")


def _kind(text: str) -> "Kind":
    from crenel.archive.records import KINDS

    for kind in KINDS:
        if kind == text:
            return kind
    raise typer.BadParameter(f"{text}: choose {', '.join(KINDS)}")


def _id(text: str) -> str:
    if Path(text).name != text or text.startswith("."):
        raise typer.BadParameter(f"{text}: give the name of a folder, without its path")
    return text


@contextmanager
def _open_archive(config: Path | None, data: Path | None) -> "Iterator[Archive]":
    """The archive of ``station.toml``.

    Raises:
        OperationError: there is no such file, it names no archive, or there is no data folder.
    """
    from crenel.archive.archive import Archive
    from crenel.archive.pace import full_speed
    from crenel.archive.records import open_record_lists
    from crenel.errors import OperationError
    from crenel.formats.file_modes import private_files
    from crenel.messages.message import message
    from crenel.settings.station_toml import read_settings

    settings = read_settings(config)
    if settings.archive is None:
        raise OperationError(
            "no-archive", message("archive-not-set"), remedy=message("archive-write-table")
        )
    folder = (data or settings.station.data).absolute()
    with private_files(), open_record_lists(folder) as lists:
        yield Archive(settings.archive, settings.station.name, folder, lists, full_speed())
