"""``crenel bench real``: boards, lines, and pictures without a line, in a folder of real ones."""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, field
from functools import partial
from pathlib import Path

from app.bench.metrology.real_boards import BoardSet, measure_boards
from app.bench.real.harder import HARDER, WIDTH_FACTORS
from app.bench.real.layout import PictureSet, find_sets
from app.bench.real.lines import (
    CRENEL,
    METHODS,
    LineSet,
    NoLineSet,
    measure_lines,
    measure_no_line,
)
from app.bench.real.peers import PEERS
from app.formats.images import GreyImage
from app.progress import Progress, no_progress

LINE_COLUMNS = (
    "set",
    "pictures",
    "with line",
    "width px",
    "points",
    "agreed",
    "missed",
    "false",
    "best peer's",
    "noise px: Crenel",
    "centroid",
    "Gauss + parabola",
    "Steger",
    "scatter / σ",
)
NO_LINE_COLUMNS = ("set", "pictures", "columns", "with points", "share")


@dataclass
class RealResults:
    """What was found in a folder, by the kind of set."""

    boards: list[BoardSet] = field(default_factory=list)
    lines: list[LineSet] = field(default_factory=list)
    no_line: list[NoLineSet] = field(default_factory=list)


@dataclass(frozen=True)
class Variant:
    """A set as it is, or made harder."""

    name: str
    source: PictureSet
    spoil: Callable[[GreyImage], GreyImage] | None = None
    width_factor: float = 1.0

    def pictures(self) -> Iterator[GreyImage]:
        pictures = self.source.pictures()
        return pictures if self.spoil is None else map(self.spoil, pictures)


def run(folder: Path, harder: bool, progress: Progress = no_progress) -> RealResults:
    """Measures all sets of a folder; with ``harder``, also what is made of each.

    Raises:
        OperationError: the folder has no sets, or a file of one cannot be read.
    """
    variants = [one for found in find_sets(folder) for one in _variants(found, harder)]
    results = RealResults()
    for number, variant in enumerate(variants):
        progress(number / len(variants), variant.name)
        _measure(results, variant)
    return results


def _variants(source: PictureSet, harder: bool) -> Iterator[Variant]:
    yield Variant(source.name, source)
    for name, spoil in HARDER.items() if harder else ():
        yield Variant(f"{source.name}, {name}", source, spoil, WIDTH_FACTORS.get(name, 1.0))


def _measure(results: RealResults, variant: Variant) -> None:
    source, about = variant.source, variant.source.about
    if source.board is not None:
        results.boards.append(measure_boards(variant.name, variant.pictures(), source.board))
    if source.without_line:
        found = measure_no_line(variant.name, variant.pictures(), about.stripe_axis)
        results.no_line.append(found)
    elif source.kind == "lines":
        width_px = None if about.width_px is None else about.width_px * variant.width_factor
        measure = partial(measure_lines, variant.name, variant.pictures, about.stripe_axis)
        results.lines.append(measure(width_px, about.several, about.repeated))


def line_table(results: Sequence[LineSet]) -> list[list[str]]:
    """Rows to print under ``LINE_COLUMNS``."""
    return [
        [
            one.name,
            str(one.pictures),
            str(one.with_line),
            "–" if one.width_px is None else f"{one.width_px:.1f}",
            str(one.points),
            str(one.agreed),
            f"{100 * one.missed / one.agreed:.1f} %" if one.agreed else "–",
            str(one.false[CRENEL]) if one.false else "–",
            str(min(one.false[peer] for peer in PEERS)) if one.false else "–",
            *(f"{one.noise_px[name]:.3f}" if name in one.noise_px else "–" for name in METHODS),
            "–" if one.scatter_ratio is None else f"{one.scatter_ratio:.2f}",
        ]
        for one in results
    ]


def no_line_table(results: Sequence[NoLineSet]) -> list[list[str]]:
    """Rows to print under ``NO_LINE_COLUMNS``."""
    return [
        [
            one.name,
            str(one.pictures),
            str(one.columns),
            str(one.points),
            f"{100 * one.share:.2f} %",
        ]
        for one in results
    ]
