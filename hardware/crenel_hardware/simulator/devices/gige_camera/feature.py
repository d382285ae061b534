"""One feature of the camera."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Literal

Kind = Literal["integer", "float", "enumeration", "boolean", "command"]


@dataclass(frozen=True)
class Feature:
    """One feature, or one for each entry of its selector."""

    name: str
    kind: Kind
    category: str
    value: float = 0
    """At power-on."""
    least: float = 0
    most: float = 1
    step: int = 1
    limit: str = ""
    """A formula for the largest value, of the names of other features."""
    unit: str = ""
    entries: Mapping[str, int] = field(default_factory=dict)
    writable: bool = True
    locked: bool = False
    """Not to be changed while pictures are taken."""
    selector: str = ""
    values: tuple[float, ...] = ()
    """At power-on, one for each entry of the selector."""

    @property
    def initial(self) -> tuple[float, ...]:
        """At power-on: one value, or one for each entry of the selector."""
        return self.values or (self.value,)
