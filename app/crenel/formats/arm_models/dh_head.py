"""The heads of the columns of a Denavit-Hartenberg table: parameter, unit, index."""

import re
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal

from crenel.errors import OperationError
from crenel.messages.message import message

Role = Literal["name", "a", "alpha", "d", "theta", "low", "high", "sign"]
PARAMETERS: tuple[Role, ...] = ("a", "alpha", "d", "theta")
_ROLES: tuple[tuple[Role, str], ...] = (
    ("name", "joint|joints|link|axis|i|n|no|no.|#|name|gelenk|achse|kinematics|"),
    ("a", "a|r|length|link length|länge"),
    ("alpha", "alpha|α|twist|link twist"),
    ("d", "d|s|link offset"),
    ("theta", "theta|θ|ϑ|q|angle|joint angle|offset|theta offset|θ offset|joint offset"),
    ("low", "min|low|lower|lowest|q min|lower limit|limit low"),
    ("high", "max|high|upper|highest|q max|upper limit|limit high"),
    ("sign", "sign|direction"),
)
_ROLE_OF = {name: role for role, names in _ROLES for name in names.split("|")}
_UNIT = re.compile(
    r"[\s\[(/,_]*\b(mm|cm|m|inch|in|deg|degrees?|rad|radians?)[\])]*$|[\[(/\s]*°[\])]*$"
)
_UNITS = {"in": "inch", "degree": "deg", "degrees": "deg", "radian": "rad", "radians": "rad"}
_INDEX = re.compile(r"[\s_{(]*i\s*([-\u2212]\s*1)?[})\s]*$")


@dataclass(frozen=True)
class Heads:
    """What the first line of a table says."""

    roles: tuple[Role | None, ...]
    """The role of each column; None for one that is not read."""
    units: dict[Role, str]
    """mm, cm, m, inch, deg or rad, of the columns that state one."""
    counts_before: bool
    """A length or twist has the index i - 1, as in modified tables."""
    unused: tuple[str, ...]


def is_head(cells: Sequence[str]) -> bool:
    """Whether a line names columns of such a table."""
    return sum(_parse_head(cell)[0] in PARAMETERS for cell in cells) >= 2


def parse_heads(cells: Sequence[str]) -> Heads:
    """What each column is.

    Raises:
        OperationError: a parameter has no column, or two.
    """
    found = [_parse_head(cell) for cell in cells]
    roles = [role for role, _, _ in found]
    missing = [name for name in PARAMETERS if name not in roles]
    twice = [name for name in PARAMETERS if roles.count(name) > 1]
    if missing or twice:
        raise OperationError(
            "dh-columns",
            message("dh-column-missing", names=", ".join(missing))
            if missing
            else message("dh-column-twice", names=", ".join(twice)),
            message("first-line-names", names=", ".join(cells)),
            message("name-dh-columns"),
        )
    return Heads(
        tuple(roles),
        {role: unit for role, unit, _ in found if role is not None and unit},
        any(before for role, _, before in found if role in ("a", "alpha")),
        tuple(cell for cell, role in zip(cells, roles, strict=True) if role is None),
    )


def _parse_head(cell: str) -> tuple[Role | None, str, bool]:
    """Role, unit, and whether the index is i - 1."""
    head = cell.strip().strip("$").replace("\\", "").lower()
    unit = ""
    if (found := _UNIT.search(head)) is not None and found.start() > 0:
        unit = _UNITS.get(found[1] or "deg", found[1] or "deg")
        head = head[: found.start()]
    head = head.replace("_", " ").replace("{", " ").replace("}", " ").strip()
    before = False
    if head not in _ROLE_OF and (index := _INDEX.search(head)) is not None:
        head, before = head[: index.start()].strip(), index[1] is not None
    return _ROLE_OF.get(head), unit, before
