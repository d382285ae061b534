"""From a Denavit-Hartenberg table to joints in mm and degrees."""

import math
from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Literal, cast

from crenel.errors import OperationError
from crenel.formats.arm_models.dh_cells import AngleUnit, Cell
from crenel.formats.arm_models.dh_head import Role
from crenel.formats.arm_models.dh_table import DhRow, DhTable, parse_dh_table
from crenel.formats.arm_models.dh_units import (
    ANGLE_UNITS,
    ask_angle,
    ask_convention,
    ask_length,
    degrees_of,
)
from crenel.formats.arm_models.model import (
    LIMIT_DEG,
    Answers,
    ImportedArm,
    ModelQuestion,
    answer_to,
)
from crenel.formats.datasheets.arm import JOINT_COUNTS, ErrorPart, JointPart, error_part
from crenel.formats.json_document import field_name
from crenel.messages.message import Text, message
from crenel.metrology.arm.link_error import LinkError, error_from_transform, error_transform
from crenel.metrology.arm.near_frames import PARALLEL
from crenel.units import MM_PER

ORDERS = (
    "a, alpha, d, theta",
    "theta, d, a, alpha",
    "theta, a, d, alpha",
    "alpha, a, d, theta",
    "alpha, a, theta, d",
    "a, d, alpha, theta",
    "d, theta, a, alpha",
    "theta, d, alpha, a",
)
"""In which tables without heads have their columns."""
LENGTHS: tuple[Role, ...] = ("a", "d")
ANGLES: tuple[Role, ...] = ("alpha", "theta", "low", "high")
Cells = Mapping[Role, Cell]


def read_dh_model(text: str, answers: Answers) -> ImportedArm:
    """An arm by its Denavit-Hartenberg table, standard or modified.

    Args:
        text: lines with tabs, semicolons, bars, commas or spaces between the cells.
        answers: what the person said to the questions of the model.

    Raises:
        OperationError: the table is incomplete or malformed, or an answer cannot be true.
    """
    table = parse_dh_table(text)
    source = message("source-dh-table", rows=len(table.rows))
    order = _ask_columns(table, answers)
    if not order.answer:
        return ImportedArm(source, (order,))
    roles = table.roles or _roles_of(order.answer)
    rows = [_cells(table, roles, row) for row in table.rows]
    count = sum(not row.is_flange for row in table.rows)
    if count not in JOINT_COUNTS or any(row.is_flange for row in table.rows[:-1]):
        what = message("not-five-to-seven-joints", field=field_name("joints"), joints=count)
        raise OperationError("dh-joint-count", what, remedy=message("give-row-of-each-joint"))
    length, angle, convention = _ask_units(table, rows[:count], answers)
    asked = (*(() if order.stated else (order,)), length, angle, convention)
    if not (length.answer and angle.answer and convention.answer):
        return ImportedArm(source, asked)
    joints = [
        _joint(row.name, cells, length.answer, angle.answer)
        for row, cells in zip(table.rows, rows, strict=True)
    ]
    if len(joints) > count:
        end = _flange_error(joints.pop(), modified=convention.answer == "dh-modified")
        joints[-1] = joints[-1].model_copy(update={"error": end})
    return ImportedArm(
        source,
        asked,
        convention=cast(Literal["dh-standard", "dh-modified"], convention.answer),
        joints=tuple(joints),
        notes=_notes(table, roles),
    )


def _cells(table: DhTable, roles: Sequence[Role | None], row: DhRow) -> Cells:
    """The cells of a row by what they are; angles with the unit that their head states."""
    units = table.heads.units
    cells: dict[Role, Cell] = {}
    for role, cell in zip(roles, row.cells, strict=True):
        if role is not None:
            unit = units.get(role)
            states = role in ANGLES and cell.unit is None and unit in ANGLE_UNITS
            cells[role] = replace(cell, unit=cast(AngleUnit, unit)) if states else cell
    return cells


def _ask_columns(table: DhTable, answers: Answers) -> ModelQuestion:
    if table.roles:
        return ModelQuestion("columns", ORDERS, ", ".join(filter(None, table.roles)), stated=True)
    possible = [order for order in ORDERS if _may_be(table, _roles_of(order))]
    likely = possible[0] if len(possible) == 1 else ""
    why: Text = message("only-order-with-right-angles") if likely else ""
    question = ModelQuestion("columns", tuple(possible or ORDERS), likely=likely, why=why)
    return replace(question, answer=answer_to(question, answers))


def _roles_of(order: str) -> tuple[Role, ...]:
    return tuple(cast(Role, name) for name in order.split(", "))


def _may_be(table: DhTable, order: Sequence[Role]) -> bool:
    """Whether joint variables, π and ° stand among angles, and no twist is an odd angle."""
    for row in table.rows:
        cells = dict(zip(order, row.cells, strict=True))
        if any(cells[name].unit or cells[name].sign for name in LENGTHS) or cells["alpha"].sign:
            return False
        twist = cells["alpha"]
        quarters = [twist.value / right for right in (90.0, math.pi / 2)]
        if not any(abs(quarter - round(quarter)) < 0.002 for quarter in quarters):
            return False
    return True


def _ask_units(
    table: DhTable, rows: Sequence[Cells], answers: Answers
) -> tuple[ModelQuestion, ModelQuestion, ModelQuestion]:
    """The questions for the unit of length, for that of angles, and for the convention."""
    stated = {table.heads.units[role] for role in LENGTHS if role in table.heads.units}
    stated |= {row[role].length_unit for row in rows for role in LENGTHS} - {""}
    if len(stated) > 1:
        raise OperationError(
            "model-length-unit",
            message("two-units-of-length", units=", ".join(sorted(stated))),
            remedy=message("give-unit-of-lengths"),
        )
    angle = ask_angle([row[role] for row in rows for role in ("alpha", "theta")], answers)
    twists = [(row["a"].value, row["alpha"].value) for row in rows]
    convention = ask_convention(table.title, table.heads.counts_before, twists, answers)
    unit = angle.answer or angle.likely
    total = _total_length(rows, unit, before=convention.answer == "dh-modified")
    return ask_length(total, next(iter(stated), ""), answers), angle, convention


def _total_length(rows: Sequence[Cells], angle: str, before: bool) -> float:
    """Sum of the lengths of an arm: offsets along parallel axes may cancel out.

    Args:
        before: a row has the twist before its joint, as modified tables have.
    """
    twists = [math.radians(degrees_of(row["alpha"], angle)) for row in rows]
    if before:
        twists = [*twists[1:], math.pi / 2]
    total, along, sense = sum(abs(row["a"].value) for row in rows), 0.0, 1.0
    for row, twist in zip(rows, twists, strict=True):
        along += sense * row["d"].value
        sense = math.copysign(sense, sense * math.cos(twist))
        if abs(math.sin(twist)) >= PARALLEL:
            total, along, sense = total + abs(along), 0.0, 1.0
    return total + abs(along)


def _joint(name: str, cells: Cells, length: str, angle: str) -> JointPart:
    low, high = -LIMIT_DEG, LIMIT_DEG
    if "low" in cells and "high" in cells:
        low, high = degrees_of(cells["low"], angle), degrees_of(cells["high"], angle)
    reverse = cells["theta"].sign < 0 or ("sign" in cells and cells["sign"].value < 0)
    return JointPart(
        name=name,
        a_mm=_mm(cells["a"], length),
        alpha_deg=degrees_of(cells["alpha"], angle),
        d_mm=_mm(cells["d"], length),
        theta_deg=degrees_of(cells["theta"], angle),
        sign=-1 if reverse else 1,
        limits_deg=(low, high),
    )


def _mm(cell: Cell, unit: str) -> float:
    """A length without what the change of unit leaves behind the last figure."""
    return round(cell.value * MM_PER[unit], 9)


def _flange_error(part: JointPart, modified: bool) -> ErrorPart | None:
    """The row of the flange as the constant transform behind the last joint."""
    along_x = LinkError(x_mm=part.a_mm, rx_rad=math.radians(part.alpha_deg))
    about_z = LinkError(z_mm=part.d_mm, rz_rad=math.radians(part.theta_deg))
    order = (along_x, about_z) if modified else (about_z, along_x)
    first, second = (error_transform(one) for one in order)
    return error_part(error_from_transform(first @ second))


def _notes(table: DhTable, roles: Sequence[Role | None]) -> tuple[Text, ...]:
    notes: list[Text] = []
    if table.decimal_commas:
        notes.append(message("decimal-commas-read"))
    if table.heads.unused:
        notes.append(message("columns-not-read", names=", ".join(table.heads.unused)))
    if table.rows[-1].is_flange:
        notes.append(message("flange-row-turns-no-joint", name=table.rows[-1].name))
    if "low" not in roles or "high" not in roles:
        notes.append(message("limits-not-stated"))
    return tuple(notes)
