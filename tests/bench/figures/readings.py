"""How a measured value is read from the JSON that a command prints."""

from collections.abc import Callable, Mapping
from typing import Any

from tests.bench.figures.figure import Read
from tests.bench.figures.printed import NUMBER, parse_number

Step = str | Mapping[str, object]


def at(*path: Step) -> Read:
    """The value at keys within each other, or the first number of its text; fields and their values
    choose one of a list."""

    def read(found: Any) -> float:
        for step in path:
            found = found[step] if isinstance(step, str) else _entry(found, step)
        if isinstance(found, str):
            return parse_number(NUMBER.findall(found)[0]).value
        return float(found)

    return read


def _entry(found: Any, fields: Mapping[str, object]) -> Any:
    (one,) = (each for each in found if all(each[key] == of for key, of in fields.items()))
    return one


def over(of: Read, to: Read) -> Read:
    return lambda found: of(found) / to(found)


def percent(read: Read) -> Read:
    return lambda found: 100 * read(found)


def reduced(of: Callable[[list[float]], float], reads: list[Read]) -> Read:
    """The smallest or largest of several values, or their sum."""
    return lambda found: float(of([read(found) for read in reads]))


def smallest_of_rows(key: str, *begins: str) -> Read:
    """Of the rows whose name begins in one of these ways: the best of several methods."""
    return lambda found: min(
        float(row[key]) for name, row in found.items() if name.startswith(begins)
    )
