"""All numbers of a performance test as tables, the same for CSV and XLSX."""

from collections.abc import Sequence

from crenel.formats.exchange.write_tables import Cell, ResultTable
from crenel.formats.json_document import Vector3
from crenel.gauges.judgement.document import PerformanceFile, SphereMeasurement


def result_tables(document: PerformanceFile) -> list[ResultTable]:
    """The tables of a test; those without rows are left out.

    Names and columns are English in every language, so that programs can rely on them. Lengths are
    in mm, errors in µm; coordinates are in the arm frame, the offset in the sensor frame.
    """
    tables = [
        _test(document),
        _figures(document),
        _values(document),
        _places(document.spheres),
        _centres(document.spheres),
        _positions(document.spheres),
        _offset(document),
        _lengths(document),
        ResultTable(
            "inputs", ("file", "sha256"), tuple((i.file, i.sha256) for i in document.inputs)
        ),
    ]
    return [table for table in tables if table.rows]


def _test(document: PerformanceFile) -> ResultTable:
    start, end = document.temperature_c
    rule, gate, serials = document.rule, document.gate, document.serial_numbers
    rows: list[tuple[Cell, ...]] = [
        ("id", document.id),
        ("kind", document.kind),
        ("station", document.station),
        ("operator", document.operator),
        ("simulated", str(document.simulated).lower()),
        ("started_at", document.started_at),
        ("ended_at", document.ended_at),
        ("edition", document.edition),
        ("standards", "; ".join(document.standards)),
        ("status", str(document.status)),
        ("verdict", document.verdict.result),
        ("rule", f"{rule.standard}:{rule.edition}"),
        ("guard_factor", rule.guard_factor),
        ("bearer", rule.bearer),
        ("gate_shell_mm", gate.shell_mm),
        ("gate_incidence_deg", gate.incidence_deg),
        ("gate_cone_deg", gate.cone_deg),
        ("arm_serial_number", serials.arm),
        ("sensor_serial_number", serials.sensor),
        ("temperature_start_c", start),
        ("temperature_end_c", end),
        *_temperatures(document),
        *_artefacts(document),
        ("software", f"{document.software.name} {document.software.version}"),
    ]
    notes = [*document.problems, *document.notes]
    rows += [(f"note_{number}", str(note)) for number, note in enumerate(notes, 1)]
    return ResultTable("test", ("name", "value"), tuple(rows))


def _temperatures(document: PerformanceFile) -> list[tuple[Cell, ...]]:
    """The temperatures of artefact and arm, if one was measured, and whether they were steady."""
    part = document.temperatures
    if part is None:
        return []
    rows: list[tuple[Cell, ...]] = []
    for name, (start, end) in (("artefact", part.artefact_c), ("arm", part.arm_c)):
        rows += [(f"{name}_temperature_start_c", start), (f"{name}_temperature_end_c", end)]
    return [
        *rows,
        ("artefact_temperature_sd_c", part.artefact_sd_c),
        ("temperature_change_limit_c", part.limits.change_c),
        ("temperature_from_20_limit_c", part.limits.from_20_c),
        ("temperature_steady", "" if part.steady is None else str(part.steady).lower()),
    ]


def _artefacts(document: PerformanceFile) -> list[tuple[Cell, ...]]:
    rows: list[tuple[Cell, ...]] = []
    parts = (("sphere", document.sphere), ("length", document.length), ("plate", document.plate))
    for name, part in parts:
        if part is None:
            continue
        for field in ("name", "serial_number", "certificate", "valid_until"):
            rows.append((f"{name}_{field}", getattr(part, field)))
    if document.sphere is not None:
        for field in ("diameter_mm", "diameter_sd_um", "form_um", "form_sd_um"):
            rows.append((f"sphere_{field}", getattr(document.sphere, field)))
    return rows


def _figures(document: PerformanceFile) -> ResultTable:
    columns = (
        "quantity", "symbol", "title", "value_um", "mpe_um", "test_uncertainty_k2_um", "decision",
        "problem", "data",
    )  # fmt: skip
    return ResultTable(
        "figures",
        columns,
        tuple(
            (
                one.quantity,
                one.symbol,
                str(one.title),
                one.value,
                one.limit,
                one.test_uncertainty,
                one.decision,
                str(one.problem),
                " ".join(one.data),
            )
            for one in document.figures
        ),
    )


def _values(document: PerformanceFile) -> ResultTable:
    rows = [
        (
            one.symbol,
            number + 1,
            value,
            one.limits[number] if number < len(one.limits) else one.limit,
        )
        for one in document.figures
        for number, value in enumerate(one.values)
    ]
    return ResultTable("values", ("symbol", "number", "value_um", "mpe_um"), tuple(rows))


def _places(spheres: Sequence[SphereMeasurement]) -> ResultTable:
    """The 25 places of each position."""
    rows: list[tuple[Cell, ...]] = []
    for one in spheres:
        touched, patches = one.touch_deviations_um, one.patches
        for place in range(max(len(touched), len(patches))):
            patch = patches[place] if place < len(patches) else None
            rows.append(
                (
                    one.position,
                    place + 1,
                    touched[place] if place < len(touched) else None,
                    patch.deviation_um if patch else None,
                    patch.points if patch else None,
                    patch.frames if patch else None,
                )
            )
    columns = ("position", "place", "touched_um", "scanned_um", "points", "frames")
    return ResultTable("places", columns, tuple(rows))


def _centres(spheres: Sequence[SphereMeasurement]) -> ResultTable:
    rows: list[tuple[Cell, ...]] = []
    for one in spheres:
        kinds: tuple[tuple[str, Sequence[Vector3]], ...] = (
            ("touch", one.tactile_centres_mm),
            ("scan", one.scan_centres_mm),
            ("scan-fixed-diameter", one.fixed_centres_mm),
        )
        for kind, centres in kinds:
            rows += [
                (one.position, kind, number, *centre) for number, centre in enumerate(centres, 1)
            ]
    columns = ("position", "by", "articulation", "x_mm", "y_mm", "z_mm")
    return ResultTable("centres", columns, tuple(rows))


def _positions(spheres: Sequence[SphereMeasurement]) -> ResultTable:
    columns = (
        "position", "moved_um", "points", "points_outside", "free_dispersion_um",
        "location_fixed_um",
    )  # fmt: skip
    rows = tuple(tuple(getattr(one, column) for column in columns) for one in spheres)
    return ResultTable("positions", columns, rows)


def _offset(document: PerformanceFile) -> ResultTable:
    offset = document.offset
    rows: tuple[tuple[Cell, ...], ...] = ()
    if offset is not None:
        pairs = zip("xyz", offset.offset_mm, offset.standard_uncertainty_mm, strict=True)
        rows = tuple(pairs)
    return ResultTable("offset", ("axis", "offset_mm", "standard_uncertainty_mm"), rows)


def _lengths(document: PerformanceFile) -> ResultTable:
    columns = (
        "by", "place", "repeat", "length_mm", "measured_mm", "error_um", "test_uncertainty_um",
        "limit_um",
    )  # fmt: skip
    rows = tuple(tuple(getattr(one, column) for column in columns) for one in document.lengths)
    return ResultTable("lengths", columns, rows)
