"""``crenel part``: what the file of a part holds."""

from enum import StrEnum
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from crenel.console import AsJson, print_figures, print_json, report_errors, warn

if TYPE_CHECKING:
    from crenel.parts.cad.evaluate_part import Part


class PartUnit(StrEnum):
    """The unit of a file's numbers."""

    MM = "mm"
    CM = "cm"
    M = "m"
    INCH = "inch"


UnitOfPart = Annotated[
    PartUnit | None,
    typer.Option("--unit", help="Of the part; by default as its file states it, else mm."),
]

BodyOfPart = Annotated[
    int | None, typer.Option("--body", min=1, help="Which of several bodies; by default, all.")
]


@report_errors
def part(
    path: Annotated[Path, typer.Argument(metavar="PART", help="The part: .stl, .step or .stp.")],
    unit: UnitOfPart = None,
    body: BodyOfPart = None,
    as_json: AsJson = False,
) -> None:
    """Show what the file of a part holds: unit, size, faces, closed or open, chord error."""
    from crenel.parts.cad.evaluate_part import read_part

    found = read_part(path, None if unit is None else unit.value, body=body)
    for note in found.notes:
        warn(note)
    if as_json:
        print_json(part_fields(found))
        return
    sides = " × ".join(f"{side:.6g}" for side in found.mesh.size_mm)
    figures = [
        ("format", found.form),
        ("unit", found.unit if found.has_unit else f"{found.unit}, not stated"),
        ("size", f"{sides} mm"),
        ("triangles", f"{len(found.mesh.triangles):,}".replace(",", " ")),
        ("surface", "closed" if found.is_closed else "open"),
        ("chord error", f"{1e3 * found.chord_error_mm:.1f} µm"),
    ]
    if found.is_closed:
        figures.insert(5, ("volume", f"{found.mesh.volume_mm3:.6g} mm³"))
    if found.bodies > 1:
        figures.insert(1, ("bodies", str(found.bodies)))
    print_figures(f"Part {path}", figures)


def part_fields(found: "Part") -> dict[str, object]:
    """What is known of a part, for programs."""
    mesh = found.mesh
    return {
        "format": found.form,
        "unit": found.unit,
        "unit_stated": found.has_unit,
        "bodies": found.bodies,
        "size_mm": mesh.size_mm.tolist(),
        "low_mm": mesh.low_mm.tolist(),
        "high_mm": mesh.high_mm.tolist(),
        "triangles": len(mesh.triangles),
        "closed": found.is_closed,
        "open_edges": int(mesh.edges.is_open.sum()),
        "area_mm2": float(mesh.areas_mm2.sum()),
        "volume_mm3": mesh.volume_mm3 if found.is_closed else None,
        "chord_error_um": 1e3 * found.chord_error_mm,
        "notes": list(map(str, found.notes)),
    }
