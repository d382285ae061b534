"""Options of the commands that work on many recordings."""

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Annotated

import typer

Places = Annotated[
    list[str] | None,
    typer.Argument(
        metavar="[PLACE]...",
        help="Archives (folders or addresses as s3://bucket/room-2), what several of them are in, "
        "or data folders of stations. Default: the archive of station.toml.",
    ),
]
Output = Annotated[
    str,
    typer.Option("-o", "--output", help="Folder, or address, to which the results go."),
]
Config = Annotated[
    Path | None,
    typer.Option("--config", help="station.toml whose [archive] has the endpoint and the keys."),
]
PeriodOption = Annotated[
    str | None,
    typer.Option("--period", help="As 2026-05-13, 2026-05, 2026 or 2026-05..2026-06-15; UTC."),
]
Station = Annotated[
    list[str] | None,
    typer.Option("--station", help="Only this station: the name of its archive's folder."),
]
TakenWith = Annotated[
    list[str] | None,
    typer.Option("--taken-with", metavar="ID", help="Only what was taken with this calibration."),
]
Record = Annotated[
    list[str] | None,
    typer.Option("--record", metavar="ID", help="Only this scan, by its id; repeatable."),
]
Label = Annotated[
    list[str] | None,
    typer.Option("--label", help="Only scans of exactly this name, as the part's; repeatable."),
]
EachCalibration = Annotated[
    list[str] | None,
    typer.Option(
        "--calibration",
        metavar="[NAME=]CALIBRATION",
        help="Use this calibration.json, or that of this session; of several sensors, one for "
        "each. Default: the one with which each recording was taken.",
    ),
]
ArmFile = Annotated[
    Path | None, typer.Option("--arm", help="arm.json; default: beside the calibration.")
]
Workers = Annotated[
    int | None,
    typer.Option(
        "--workers", min=1, max=1024, help="Processes on this machine. Default: one per core."
    ),
]
Scheduler = Annotated[
    str | None,
    typer.Option(
        "--scheduler",
        metavar="tcp://HOST:8786",
        help="Use this cluster of Dask; whoever reaches it runs programs there and here.",
    ),
]


@dataclass(frozen=True)
class BatchOptions:
    """What such commands are given, apart from the places."""

    output: str
    period: str | None
    station: Sequence[str] | None
    taken_with: Sequence[str] | None
    workers: int | None
    scheduler: str | None
    config: Path | None
    as_json: bool


def name_places(given: Sequence[str]) -> bool:
    """Whether arguments are folders or addresses, and no files.

    Raises:
        typer.BadParameter: some are, and some are not.
    """
    found = {"://" in one or Path(one).is_dir() for one in given}
    if len(found) > 1:
        raise typer.BadParameter("give files, or archives and data folders, but not both")
    return found == {True}
