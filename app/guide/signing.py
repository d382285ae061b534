"""What a record says of where and by whom it was made."""

from collections.abc import Callable
from dataclasses import dataclass


@dataclass(frozen=True)
class Signing:
    """``operator`` tells who has control at the moment; empty where nobody has."""

    station: str = ""
    simulated: bool = False
    operator: Callable[[], str] = str


UNSIGNED = Signing()
