"""``crenel backup`` and ``crenel mqtt-schema``: what a station's keeper needs."""

import json
from pathlib import Path
from typing import Annotated

import typer

from app.console import print_json, progress_bar, refusing


@refusing
def backup(
    data: Annotated[Path, typer.Argument(help="The station's data folder; it may be running.")],
    output: Annotated[Path, typer.Option("-o", "--output", help="The new folder of the copy.")],
    as_json: Annotated[
        bool, typer.Option("--json", help="Print the result for programs on stdout.")
    ] = False,
) -> None:
    """Copy a station's data folder, also while it runs; start from the copy with --data."""
    from dataclasses import asdict

    from app.store.backup import backup as copy_all

    with progress_bar("Copying", not as_json) as tell:
        made = copy_all(data, output, tell)
    if as_json:
        print_json(asdict(made))
        return
    print(f"{made.folder} written: {made.files} files, {made.bytes / 1e6:.1f} MB")


@refusing
def mqtt_schema() -> None:
    """The JSON schema of what stations publish over MQTT."""
    from app.supervise.messages import schema

    print(json.dumps(schema(), indent=1, ensure_ascii=False))
