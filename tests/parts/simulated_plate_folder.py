"""An inspection folder of the simulated plate: datums by scan and tip, drawing, limits of a map."""

import json
from pathlib import Path

from tests.parts.bracket_program import datum_touches
from tests.parts.meshes import write_stl
from tests.parts.simulated_inspection import (
    Planned,
    Station,
    draw_truth,
    scan_part,
    touch_rows,
    write_station,
    write_touches,
)
from tests.parts.simulated_plate import Plate

LIMITS_MM = (-0.04, 0.04)


def write_plate_folder(
    folder: Path, plate: Plate, station: Station, planned: list[Planned], seed: int
) -> None:
    """A folder whose recording is by the station as it truly is in a draw."""
    write_station(folder, station)
    (folder / "scans").mkdir()
    truth = draw_truth(station, seed)
    scan_part(folder / "scans" / "scan.mcap", plate, truth, planned, seed)
    write_touches(folder, station, touch_rows(station, truth, datum_touches(plate), seed))
    write_stl(folder / "part.stl", plate.corners())
    w, h = plate.size_mm
    z = plate.top_mm

    def plane(
        name: str, point: tuple[float, ...], normal: tuple[int, ...], *box: tuple[float, ...]
    ) -> dict[str, object]:
        nominal = {"point_mm": point, "normal": normal}
        return {"id": name, "kind": "plane", "nominal": nominal, "region": {"boxes_mm": [box]}}

    program = {
        "format": "crenel/inspection-program",
        "version": 1,
        "name": "Plate",
        "features": [
            plane("A", (w / 2, h / 2, z), (0, 0, 1), (45, 2, z - 1), (75, 47, z + 1)),
            plane("B", (w / 2, 0, z / 2), (0, -1, 0), (1, -1, 8), (w - 1, 1, z - 1)),
            plane("C", (0, h / 2, z / 2), (-1, 0, 0), (-1, 1, 8), (1, h - 1, z - 1)),
        ],
        "alignment": {"kind": "datums", "primary": "A", "secondary": "B", "tertiary": "C"},
        "map": {"radius_mm": 1.5, "lower_mm": LIMITS_MM[0], "upper_mm": LIMITS_MM[1]},
    }
    (folder / "program.json").write_text(json.dumps(program))
