"""Runs the commands that measure figures, each once."""

import json
import subprocess
import sys
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Any

from tests.bench.figures.figure import Command, Figure, Outcome, Verdict, compare
from tests.bench.figures.pictures import LAID_OUT
from tests.bench.figures.printed import ROOT
from tests.bench.real_folder import lay_out

STARTED_MODULES = ()  # benches, which no test runs
SHARED = ROOT.parent / "shared"
END = 400
"""Characters of what a failed command says."""


class MeasureError(Exception):
    """A command failed, or printed something else than JSON."""

    verdict = Verdict.UNREADABLE


class MissingError(MeasureError):
    """A folder that a command needs is not beside the checkout."""

    verdict = Verdict.NOT_MEASURED


def outcomes(figures: Sequence[Figure], scratch: Path) -> Iterator[Outcome]:
    """Each figure measured, those of one command one after another. What another run has left in
    the folder ``scratch`` is read instead."""
    for command in dict.fromkeys(figure.command for figure in figures):
        of_command = [figure for figure in figures if figure.command == command]
        try:
            output = measure(command, scratch)
        except MeasureError as error:
            yield from (Outcome(one, error.verdict, why=str(error)) for one in of_command)
        else:
            yield from (compare(figure, output) for figure in of_command)


def measure(command: Command, scratch: Path) -> Any:
    """What a command prints, parsed; from ``scratch`` if it is there. MeasureError: it failed."""
    kept = scratch / f"{file_name(command)}.json"
    if not kept.exists():
        words = arguments(command, scratch)
        print(f"+ {command}", file=sys.stderr, flush=True)
        done = subprocess.run(words, cwd=ROOT, capture_output=True, text=True)
        if done.returncode:
            raise MeasureError(f"status {done.returncode}: {done.stderr.strip()[-END:]}")
        kept.write_text(done.stdout, "utf-8")
    try:
        return json.loads(kept.read_text("utf-8"))
    except ValueError as error:
        raise MeasureError(f"{kept} is no JSON: {error}") from error


def file_name(command: Command) -> str:
    return "".join(letter if letter.isalnum() else "-" for letter in str(command))


def arguments(command: Command, scratch: Path) -> list[str]:
    """The command as a process, with JSON as its output. MissingError: a folder is missing."""
    _, *words = command.documented.split()  # python
    stands_for = dict(command.folders)
    found = [_word(stands_for.get(word, word), word in stands_for, scratch) for word in words]
    return [sys.executable, *found, *command.more, "--json"]


def _word(word: str, replaced: bool, scratch: Path) -> str:
    """A word of a command, or the folder that it stands for."""
    if not replaced or word.isdigit():
        return word
    laid_out, real = scratch / "pictures", SHARED / "real"
    if word.startswith(LAID_OUT):
        if not real.is_dir():
            raise MissingError(f"{real} is missing")
        if not laid_out.exists():
            lay_out(real, laid_out)
        return str(laid_out / word.removeprefix(LAID_OUT).strip("/"))
    if not (SHARED / word).is_dir():
        raise MissingError(f"{SHARED / word} is missing")
    return str(SHARED / word)
