"""The demonstration: the simulated station, with its papers in a data folder."""

import json
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from app.errors import Refusal
from app.formats.atomic_write import write_atomically
from app.formats.datasheets.arm import ArmFile
from app.formats.io_errors import files_refused
from app.operations.services import Watching
from app.server.composition import Parts
from hardware.registry import arm_driver
from hardware.simulator.scene.room import RoomThermometer
from hardware.simulator.station import Twin

PLACES = {
    "arm.json": "arms/simulated.json",
    "object.json": "objects/simulated.json",
    "chessboard.json": "objects/chessboard.json",
    "sensor.json": "sensors/simulated.json",
}
"""Where a paper belongs in the data folder; those of gauges into their own."""


@contextmanager
def simulated_parts(data: Path) -> Iterator[Parts]:
    """A running twin, its sensor ready to take pictures, as the parts of a station.

    Raises:
        Refusal: the data folder cannot be written.
    """
    with Twin() as twin:
        yield parts_of(twin, data)


def parts_of(twin: Twin, data: Path) -> Parts:
    """A station on a started twin; the real serial driver reads its arm."""
    put_papers(twin, data)
    options = {"url": twin.arm_url}
    return Parts(
        name="Demonstration",
        data=data,
        arm=lambda: arm_driver("serial-encoder", options),
        sensor=twin.sensor,
        hand=twin.hand,
        guest="Demo",
        watching=Watching(
            thermometer=RoomThermometer(),
            told={"drivers": {"arm": "serial-encoder", "sensor": "simulated"}},
        ),
    )


def _identified(path: Path) -> bool:
    """Whether a file holds an arm that was identified."""
    try:
        return ArmFile.read(path).identification is not None
    except Refusal:
        return False


def put_papers(twin: Twin, data: Path) -> None:
    """Writes what an operator would be given with the devices into the data folder."""
    for name, paper in twin.papers().items():
        content = (json.dumps(paper, indent=1) + "\n").encode()
        target = data / PLACES.get(name, f"gauges/{name}")
        with _data_folder_refused(data), files_refused(target.parent):
            if name == "arm.json" and _identified(target):
                continue  # it is known better than its papers have it
            target.parent.mkdir(parents=True, exist_ok=True)
            write_atomically(target, content)


@contextmanager
def _data_folder_refused(data: Path) -> Iterator[None]:
    """Names the option by which another folder is given, where that is the remedy."""
    try:
        yield
    except Refusal as refusal:
        if refusal.code in ("disk-full", "output-not-a-file"):
            raise
        raise Refusal(
            "data-folder-unwritable",
            f"The data folder {data} cannot be used",
            f"{refusal.what}: {refusal.why}",
            "Give a folder that this user may write with --data",
        ) from refusal
