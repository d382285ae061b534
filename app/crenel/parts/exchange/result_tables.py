"""All numbers of an inspection as tables, the same for CSV and XLSX."""

from crenel.formats.exchange.write_tables import Cell, ResultTable
from crenel.parts.document_results import DimensionResult, InspectionFile


def result_tables(document: InspectionFile) -> list[ResultTable]:
    """The tables of an inspection, that of the dimensions first; those without rows are left out.

    Names and columns are English in every language, so that programs can rely on them.
    """
    tables = [
        dimensions_table(document),
        _features(document),
        _parameters(document),
        _exclusions(document),
        _alignment(document),
        _correlation(document),
        _about(document),
        ResultTable(
            "inputs", ("file", "sha256"), tuple((i.file, i.sha256) for i in document.inputs)
        ),
    ]
    return [table for table in tables if table.rows]


def dimensions_table(document: InspectionFile) -> ResultTable:
    """Each dimension with its limits, uncertainty (k = 2), decision and budget (k = 1)."""
    sources = budget_sources(document)
    rows = []
    for one in document.dimensions:
        u, scatter = one.standard_uncertainty, one.scatter
        row: list[Cell] = [
            *(one.id, one.kind, " ".join(one.features), one.unit, one.nominal),
            *(one.lower, one.upper, one.value, one.value - one.nominal),
            None if u is None else 2 * u,
            None if scatter is None else 2 * scatter,
            *(one.decision, one.probability, one.by_chance),
            *(one.contributions.get(name) for name in sources),
        ]
        rows.append(tuple(row))
    columns = (
        *("dimension", "kind", "features", "unit", "nominal", "lower", "upper", "measured"),
        *("deviation", "U_k2", "scatter_k2", "decision", "probability", "by_chance"),
        *(f"u_{name}" for name in sources),
    )
    return ResultTable("dimensions", columns, tuple(rows))


def budget_sources(document: InspectionFile) -> list[str]:
    """The sources of uncertainty that any dimension has, in the order of the budget."""

    def named(one: DimensionResult) -> dict[str, None]:
        return dict.fromkeys(name for name, value in one.contributions.items() if value > 0)

    found: dict[str, None] = {}
    for one in document.dimensions:
        found |= named(one)
    return list(found)


def _features(document: InspectionFile) -> ResultTable:
    columns = ("feature", "by", "kind", "points", "used", "frames", "cells", "rms_um", "form_um")
    rows = tuple(
        (
            *(one.id, one.source, one.kind, one.points, one.used, one.frames, one.cells),
            *(one.rms_um, one.form_um),
        )
        for one in document.features
    )
    return ResultTable("features", columns, rows)


def _parameters(document: InspectionFile) -> ResultTable:
    """Place, direction and sizes of each feature in the part frame."""
    rows: list[tuple[Cell, ...]] = []
    for one in document.features:
        for name, value in one.parameters.items():
            nominal = (one.nominal or {}).get(name)
            numbers = value if isinstance(value, tuple) else (value,)
            drawn = nominal if isinstance(nominal, tuple) else (nominal,) * len(numbers)
            names = [f"{name}.{axis}" for axis in "xyz"] if len(numbers) == 3 else [name]
            for each, number, as_drawn in zip(names, numbers, drawn, strict=True):
                rows.append((one.id, one.source, each, as_drawn, number))
    columns = ("feature", "by", "parameter", "nominal", "measured")
    return ResultTable("parameters", columns, tuple(rows))


def _exclusions(document: InspectionFile) -> ResultTable:
    rows = tuple(
        (one.id, one.source, each.rule, each.count)
        for one in document.features
        for each in one.excluded
    )
    return ResultTable("exclusions", ("feature", "by", "rule", "count"), rows)


def _alignment(document: InspectionFile) -> ResultTable:
    """What the part frame is known to, at each feature and at the far corner."""
    rows: list[tuple[Cell, ...]] = []
    if (found := document.alignment) is not None:
        corner = () if found.far_corner is None else (found.far_corner,)
        for one in (*found.known_at, *corner):
            role = "datum" if one.feature in found.datums else "feature"
            rows.append(
                (one.feature, role if one.feature else "far-corner", *one.point_mm, one.u_um)
            )
    columns = ("feature", "role", "x_mm", "y_mm", "z_mm", "u_um_k1")
    return ResultTable("alignment", columns, tuple(rows))


def _correlation(document: InspectionFile) -> ResultTable:
    names = tuple(one.id for one in document.dimensions)
    rows: tuple[tuple[Cell, ...], ...] = ()
    if document.correlation is not None:
        rows = tuple((name, *row) for name, row in zip(names, document.correlation, strict=True))
    return ResultTable("correlation", ("dimension", *names), rows)


def _about(document: InspectionFile) -> ResultTable:
    rule, software = document.rule, document.software
    rows: list[tuple[Cell, ...]] = [
        ("program", document.program),
        ("part", document.part),
        ("drawing", document.drawing),
        ("serial_number", document.serial_number),
        ("measured_at", document.measured_at),
        ("verdict", document.verdict),
        *((name, document.count(name)) for name in ("pass", "fail", "undecided", "none")),
        ("uncertainty", document.uncertainty),
        ("correlation_unknown", str(document.correlation_unknown).lower()),
        ("rule", f"{rule.standard}:{rule.edition}"),
        ("guard_factor", rule.guard_factor),
        ("bearer", rule.bearer),
        ("software", "" if software is None else f"{software.name} {software.version}"),
    ]
    rows += [(f"warning_{n}", str(text)) for n, text in enumerate(document.warnings, 1)]
    return ResultTable("inspection", ("name", "value"), tuple(rows))
