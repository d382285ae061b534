"""Boards, lines, and pictures without a line, in a folder of real ones: the benchmark ``real``."""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, field
from functools import partial
from pathlib import Path

from crenel.formats.images import GreyImage
from crenel.metrology.stripe import AUTOMATIC, StripeSettings
from crenel.progress import Progress, no_progress
from tests.bench.metrology.real_boards import BoardSet, measure_boards
from tests.bench.real.drawings import write_drawing
from tests.bench.real.harder import HARDER, WIDTH_FACTORS
from tests.bench.real.layout import (
    LazyPicture,
    PictureSet,
    PictureSetNotes,
    drop_unreadable,
    find_sets,
)
from tests.bench.real.lines import (
    CRENEL,
    METHODS,
    LineSet,
    NoLineSet,
    Show,
    measure_lines,
    measure_no_line,
    show_nothing,
)
from tests.bench.real.peers import PEERS

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
    unknown_boards: list[str] = field(default_factory=list)
    """Sets of boards whose board is not stated, and not looked for."""
    unreadable: list[str] = field(default_factory=list)
    """Why a picture could not be read; it is left out."""


@dataclass(frozen=True)
class Variant:
    """A set as it is, or made harder."""

    name: str
    source: PictureSet
    spoil: Callable[[GreyImage], GreyImage] | None = None
    width_factor: float = 1.0

    def pictures(self) -> list[LazyPicture]:
        pictures, spoil = self.source.pictures(), self.spoil
        if spoil is None:
            return pictures
        return [LazyPicture(one.name, _spoil_later(one, spoil)) for one in pictures]

    @property
    def about(self) -> PictureSetNotes:
        about = self.source.about
        if about.width_px is None:
            return about
        return about.model_copy(update={"width_px": about.width_px * self.width_factor})


def _spoil_later(
    picture: LazyPicture, spoil: Callable[[GreyImage], GreyImage]
) -> Callable[[], GreyImage]:
    return lambda: spoil(picture.load())


def run(
    folder: Path,
    harder: bool,
    progress: Progress = no_progress,
    drawings: Path | None = None,
    settings: StripeSettings = AUTOMATIC,
) -> RealResults:
    """Measures all sets of a folder; with ``harder``, also what is made of each.

    Args:
        drawings: a folder for each picture with what was found in it.
        settings: of the extraction of lines, where there are some.

    Raises:
        OperationError: the folder has no sets, or a set no picture that can be read.
    """
    results = RealResults()
    variants: list[Variant] = []
    for found in find_sets(folder):
        readable, refusals = drop_unreadable(found)
        results.unreadable += [refusal.line for refusal in refusals]
        variants += _variants(readable, harder)
    for number, variant in enumerate(variants):
        progress(number / len(variants), variant.name)
        draw = drawings and partial(write_drawing, drawings / variant.name)
        _measure(results, variant, draw or show_nothing, settings)
    return results


def _variants(source: PictureSet, harder: bool) -> Iterator[Variant]:
    yield Variant(source.name, source)
    for name, spoil in HARDER.items() if harder else ():
        yield Variant(f"{source.name}, {name}", source, spoil, WIDTH_FACTORS.get(name, 1.0))


def _measure(results: RealResults, variant: Variant, show: Show, settings: StripeSettings) -> None:
    source, pictures = variant.source, variant.pictures()
    if source.board is not None:
        loaded = (picture.load() for picture in pictures)
        results.boards.append(measure_boards(variant.name, loaded, source.board))
    elif source.kind == "boards":
        results.unknown_boards.append(variant.name)
    if source.without_line:
        results.no_line.append(measure_no_line(variant.name, pictures, variant.about, show))
    elif source.kind == "lines":
        found = measure_lines(variant.name, pictures, variant.about, show, settings)
        results.lines.append(found)


def line_table(results: Sequence[LineSet]) -> list[list[str]]:
    """Rows to print under ``LINE_COLUMNS``."""
    return [
        [
            one.name,
            str(one.pictures),
            str(one.with_line),
            _cell(one.width_px, 1),
            str(one.points),
            str(one.agreed),
            f"{100 * one.missed / one.agreed:.1f} %" if one.agreed else "–",
            str(one.false[CRENEL]) if one.false else "–",
            str(min(one.false[peer] for peer in PEERS)) if one.false else "–",
            *(_cell(one.noise_px.get(name), 3) for name in METHODS),
            _cell(one.scatter_ratio, 2),
        ]
        for one in results
    ]


def _cell(value: float | None, decimals: int) -> str:
    return "–" if value is None else f"{value:.{decimals}f}"


def no_line_table(results: Sequence[NoLineSet]) -> list[list[str]]:
    """Rows to print under ``NO_LINE_COLUMNS``."""
    return [
        [one.name, str(one.pictures), str(one.columns), str(one.points), f"{100 * one.share:.2f} %"]
        for one in results
    ]
