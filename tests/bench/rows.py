"""The rows that a bench of this folder measures: printed for a reader, or as JSON."""

import argparse
import json
from collections.abc import Generator, Mapping
from contextlib import contextmanager

import numpy as np

from crenel.metrology.transforms import Floats

WIDTH = 44


class Rows:
    """Named rows of numbers. A reader sees each when it is measured."""

    def __init__(self, as_json: bool) -> None:
        self.as_json = as_json
        self.values: dict[str, dict[str, float]] = {}
        self._columns: tuple[str, ...] = ()

    def add(self, name: str, values: Mapping[str, float]) -> None:
        """A row of values by column."""
        self.values[name] = {column: float(value) for column, value in values.items()}
        if self.as_json:
            return
        if tuple(values) != self._columns:
            self._columns = tuple(values)
            print(f"{'':<{WIDTH}}" + "".join(f"{column:>20}" for column in values))
        print(f"{name:<{WIDTH}}" + "".join(f"{v:>20.5g}" for v in values.values()), flush=True)

    def say(self, text: str) -> None:
        """A remark, for readers alone."""
        if not self.as_json:
            print(text, flush=True)


def rms(values: Floats) -> float:
    return float(np.sqrt(np.mean(values**2)))


def bench_parser(doc: str) -> argparse.ArgumentParser:
    """The options of a bench, by its docstring: ``--json``, and what it adds."""
    parser = argparse.ArgumentParser(description=doc.splitlines()[0])
    parser.add_argument("--json", action="store_true", help="print one JSON object of all rows")
    return parser


@contextmanager
def measured_rows(as_json: bool) -> Generator[Rows]:
    """Rows to fill; in JSON they are printed together at the end."""
    rows = Rows(as_json)
    yield rows
    if as_json:
        print(json.dumps(rows.values))
