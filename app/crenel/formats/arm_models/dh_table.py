"""The rows of a Denavit-Hartenberg table, pasted or from a file."""

import re
from collections.abc import Sequence
from dataclasses import dataclass

from crenel.errors import OperationError
from crenel.formats.arm_models.dh_cells import Cell, parse_cell
from crenel.formats.arm_models.dh_head import Heads, Role, is_head, parse_heads
from crenel.messages.message import Message, message

FLANGE_WORDS = ("flange", "flansch", "ee", "tool0", "end effector")
"""Names of a last row that turns about no joint."""
_JOINT_WORD = re.compile(r"\b(joint|link|axis|gelenk|achse)\s+(?=\d)", re.IGNORECASE)
_UNIT_APART = re.compile(
    r"\s+(?=[\[(](?:mm|cm|m|in|inch|deg|°|rad)[\])])"
    r"|(?<=[\d.])\s+(?=°|(?:mm|cm|m|in|inch|deg|rad)(?![\w\[(]))",
    re.IGNORECASE,
)
_RULE = re.compile(r"[\s|:+=\-_.]*")
"""A line between head and rows."""


@dataclass(frozen=True)
class DhRow:
    """One line of the table; its ``cells`` in the order of the text, without the name."""

    line: int
    name: str
    cells: tuple[Cell, ...]

    @property
    def is_flange(self) -> bool:
        """Whether it turns about no joint."""
        return self.name.strip().lower() in FLANGE_WORDS


@dataclass(frozen=True)
class DhTable:
    """A table as it stands there."""

    title: str
    """The lines before it."""
    roles: tuple[Role | None, ...]
    """The roles of the cells of a row; empty if no line names the columns, which are then four."""
    heads: Heads
    rows: tuple[DhRow, ...]
    decimal_commas: bool


@dataclass(frozen=True)
class _Line:
    number: int
    cells: list[str]


def parse_dh_table(text: str) -> DhTable:
    """Reads the cells of a table, which tabs, semicolons, bars, commas or spaces separate.

    Raises:
        OperationError: there is no table; a row has more or fewer cells; a cell is no number; a
            parameter has no column; or a row is missing, by the numbers of the others.
    """
    separator = _separator(text)
    lines = [
        _Line(number, _split(line, separator))
        for number, line in enumerate(text.splitlines(), 1)
        if not _RULE.fullmatch(line)
    ]
    first = next((k for k, line in enumerate(lines) if _is_row(line)), None)
    if first is None:
        what, remedy = message("no-dh-table"), message("paste-dh-table")
        raise OperationError("model-not-recognized", what, remedy=remedy)
    before, lines = lines[:first], lines[first:]
    named = bool(before) and is_head(before[-1].cells)
    heads = parse_heads(before.pop().cells) if named else Heads((), {}, False, ())
    roles: list[Role | None] = list(heads.roles)
    if named and "name" not in roles and len(lines[0].cells) == len(roles) + 1:
        roles.insert(0, "name")  # as in the tables of Universal Robots
    width = len(roles) or len(lines[0].cells)
    if width not in (4, 5) and not named:
        raise OperationError(
            "dh-columns",
            message("dh-row-has-cells", line=lines[0].number, count=width),
            message("dh-needs-four-numbers"),
            message("name-dh-columns"),
        )
    if not named:
        roles = [None] * 4
        if width == 5:
            roles.insert(0, "name")
    for line in lines:
        _check_width(line, width, separator)
    commas = _replace_decimal_commas(lines, separator)
    rows = tuple(_read_row(line, roles, named, k + 1) for k, line in enumerate(lines))
    _refuse_missing_rows(rows)
    plain = tuple(role for role in roles if role != "name") if named else ()
    title = " ".join(" ".join(line.cells) for line in before)
    return DhTable(title, plain, heads, rows, commas)


def _separator(text: str) -> str:
    """What stands between the cells."""
    lines = [line for line in text.splitlines() if re.search(r"\d", line)]
    for sign in ("\t", ";", "|"):
        if sum(line.count(sign) >= 3 for line in lines) * 2 > len(lines):
            return sign
    spaced = [len(_JOINT_WORD.sub(r"\1", line).split()) >= 4 for line in lines]
    if sum("," in line for line in lines) * 2 > len(lines):
        commas_end_cells = any(re.search(r",(\s|$)", line) for line in lines)
        if commas_end_cells or sum(spaced) * 2 <= len(lines):
            return ","
    return " "


def _split(line: str, separator: str) -> list[str]:
    line = _JOINT_WORD.sub(r"\1", _UNIT_APART.sub("", line.strip().strip("|")))
    if separator in (",", " "):
        line = line.strip("[](){},; ")
    cells = line.split() if separator == " " else line.split(separator)
    return [cell.strip().strip("\"'").rstrip(":").strip() for cell in cells]


def _is_row(line: _Line) -> bool:
    numbers = sum(parse_cell(cell.replace(",", ".")) is not None for cell in line.cells)
    return numbers >= 3 and not is_head(line.cells)


def _check_width(line: _Line, width: int, separator: str) -> None:
    if len(line.cells) == width:
        return
    more = len(line.cells) > width and separator == ","
    raise OperationError(
        "row-length",
        message("dh-row-has-cells", line=line.number, count=len(line.cells)),
        message("dh-table-has-columns", count=width),
        message("dh-commas-between-cells") if more else message("complete-delete-row"),
    )


def _replace_decimal_commas(lines: Sequence[_Line], separator: str) -> bool:
    """Writes the decimal commas of numbers as points; says whether there were some.

    Raises:
        OperationError: some have commas and others points.
    """
    cells = [cell for line in lines for cell in line.cells if parse_cell(cell.replace(",", "."))]
    with_comma = [cell for cell in cells if "," in cell]
    if separator == "," or not with_comma:
        return False
    with_point = next((cell for cell in cells if "." in cell), None)
    if with_point is not None:
        raise OperationError(
            "decimal-signs-mixed",
            message("decimal-signs-mixed", one=with_comma[0], other=with_point),
            remedy=message("write-all-numbers-with-point"),
        )
    for line in lines:
        line.cells[:] = [cell.replace(",", ".") for cell in line.cells]
    return True


def _read_row(line: _Line, roles: Sequence[Role | None], named: bool, count: int) -> DhRow:
    cells, name = [], f"J{count}"
    for role, text in zip(roles, line.cells, strict=True):
        if role == "name":
            name = f"J{text}" if text.isdecimal() else text or name
            continue
        cell = parse_cell(text)
        if cell is None and (role is not None or not named):
            raise OperationError(
                "cell-not-a-number",
                _cell_place(line.number, role, text),
                message("dh-number-expected"),
                message("correct-cell-delete-row"),
            )
        if cell is not None and cell.sign and named and role not in (None, "theta"):
            raise OperationError(
                "dh-joint-not-rotary",
                _cell_place(line.number, role, text),
                message("dh-variable-not-an-angle"),
                message("rotary-joints-only"),
            )
        cells.append(cell or Cell(0.0))
    return DhRow(line.number, name, tuple(cells))


def _cell_place(line: int, role: Role | None, text: str) -> Message:
    return message("dh-cell", line=line, column=role or "", value=repr(text))


def _refuse_missing_rows(rows: Sequence[DhRow]) -> None:
    """By the numbers in the names of the rows, if each has one."""
    joints = [row for row in rows if not row.is_flange]
    numbers = [re.search(r"(\d+)\D*$", row.name) for row in joints]
    found = [int(number[1]) for number in numbers if number is not None]
    if len(found) < len(joints) or not found:
        return
    expected = list(range(min(found[0], 1), min(found[0], 1) + len(found)))
    if found == expected:
        return
    missing = sorted(set(range(expected[0], max(found) + 1)) - set(found))
    raise OperationError(
        "dh-row-missing",
        message("dh-rows-missing", names=", ".join(map(str, missing)))
        if missing
        else message("dh-rows-out-of-order", names=", ".join(map(str, found))),
        message("dh-rows-there", names=", ".join(row.name for row in joints)),
        message("add-dh-row"),
    )
