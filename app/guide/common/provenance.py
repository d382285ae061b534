"""What a record says of where and by whom it was made."""

from collections.abc import Callable
from dataclasses import dataclass


def _not_measured() -> float | None:
    return None


@dataclass(frozen=True)
class Provenance:
    """``operator`` gives who has control or had it last, empty where nobody did;
    ``temperature_c`` the room's, None where it is not measured."""

    station: str = ""
    simulated: bool = False
    operator: Callable[[], str] = str
    temperature_c: Callable[[], float | None] = _not_measured


NO_PROVENANCE = Provenance()
