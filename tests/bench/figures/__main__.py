"""Measures the figures that README.md and docs/accuracy.md print, and compares them.

    .ci/figures [NAME...] [--list] [--keep FOLDER] [--complete]

NAME: of a figure, its beginning; all by default. The status is 1 if a figure is worse than the
printed one by more than its tolerance, and 2 if one cannot be read: from the document, or from
what its command prints. Figures that need the sample folders beside the checkout are not measured
without them.
"""

import argparse
import sys
import tempfile
from collections import Counter
from collections.abc import Iterable, Sequence
from pathlib import Path

from tests.bench.figures.everything import FIGURES
from tests.bench.figures.figure import Figure, Outcome, Verdict
from tests.bench.figures.measure import outcomes


def main(words: Sequence[str] | None = None) -> int:
    """The status of the process."""
    parser = argparse.ArgumentParser(
        prog=".ci/figures",
        description=__doc__,
        formatter_class=argparse.RawDescriptionHelpFormatter,
        allow_abbrev=False,
    )
    parser.add_argument("name", nargs="*")
    parser.add_argument("--list", action="store_true", help="print figures and their commands")
    keep = "keep what the commands print here, and measure only what is missing here"
    parser.add_argument("--keep", type=Path, metavar="FOLDER", help=keep)
    complete = "status 2 also if a figure is not measured"
    parser.add_argument("--complete", action="store_true", help=complete)
    given = parser.parse_args(words)
    chosen = choose(given.name)
    if not chosen:
        parser.error("no figure has such a name: --list prints all")
    if given.list:
        for figure in chosen:
            print(f"{figure.name}\n    {figure.command}\n    tolerance {figure.tolerance.reason}")
        return 0
    with tempfile.TemporaryDirectory() as scratch:
        folder = given.keep or Path(scratch)
        folder.mkdir(parents=True, exist_ok=True)
        return show(outcomes(chosen, folder), given.complete)


def choose(names: Sequence[str]) -> list[Figure]:
    """The figures whose name begins with one of the names."""
    return [one for one in FIGURES if not names or one.name.startswith(tuple(names))]


def show(found: Iterable[Outcome], complete: bool) -> int:
    """Prints the table, and returns the status."""
    _print_row("figure", "printed", "measured", "allowed", "verdict")
    verdicts: Counter[Verdict] = Counter()
    for one in found:
        verdicts[one.verdict] += 1
        printed = "" if one.printed is None else f"{one.printed.value:g}"
        value = "" if one.measured is None else f"{one.measured:.4g}"
        allowed = "" if one.printed is None else f"{one.figure.allowed(one.printed):.2g}"
        why = f"{one.verdict.value}  {one.why or one.figure.tolerance.reason}"
        _print_row(one.figure.name, printed, value, allowed, why)
    print(", ".join(f"{count} {verdict.value}" for verdict, count in verdicts.items()))
    if verdicts[Verdict.UNREADABLE] or (complete and verdicts[Verdict.NOT_MEASURED]):
        return 2
    return 1 if verdicts[Verdict.WORSE] else 0


def _print_row(name: str, printed: str, value: str, allowed: str, verdict: str) -> None:
    print(f"{name:<64}{printed:>10}{value:>10}{allowed:>10}  {verdict}", flush=True)


if __name__ == "__main__":
    sys.exit(main())
