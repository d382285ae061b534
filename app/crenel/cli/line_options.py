"""The options by which the laser's line is looked for in pictures, the same of every command."""

import inspect
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from enum import StrEnum
from functools import wraps
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

if TYPE_CHECKING:
    from crenel.formats.settings.line_settings import LineSettings
    from crenel.metrology.channel import Channel


class PeakOption(StrEnum):
    CONTINUITY = "continuity"
    STRENGTH = "strength"
    FIRST = "first"
    LAST = "last"


class ColourOption(StrEnum):
    """A laser's colour."""

    RED = "red"
    GREEN = "green"
    BLUE = "blue"


class BayerOption(StrEnum):
    """The colours of a raw picture's first two pixels, and of the two below them."""

    RGGB = "RGGB"
    BGGR = "BGGR"
    GRBG = "GRBG"
    GBRG = "GBRG"


Colour = Annotated[
    ColourOption | None,
    typer.Option(help="Of the laser: its channel is measured in colour pictures."),
]
Bayer = Annotated[
    BayerOption | None,
    typer.Option(
        help="The pictures are raw ones of a colour camera, whose cells have these colours: only"
        " the pixels of the laser's colour are measured."
    ),
]
Threshold = Annotated[
    float | None, typer.Option(help="Grey levels above its surroundings. Else by the noise.")
]
Width = Annotated[
    float | None, typer.Option(help="Pixels at half height. Else by the usual width.")
]
Choice = Annotated[
    PeakOption, typer.Option(help="Which of several peaks of a column is the stripe.")
]
Smoothing = Annotated[
    float,
    typer.Option(
        metavar="PX",
        help="Smooth along the line: standard deviation in pixels, 0 for none. Structures of"
        " period λ keep exp(-2(π·PX/λ)²) of their height, half at λ = 5.3·PX.",
    ),
]
MaskFile = Annotated[
    Path | None, typer.Option(help="mask.json: zones in which nothing is measured.")
]


@dataclass(frozen=True)
class LineOptions:
    """What a command line says of the line; the fields are its options, in this order."""

    threshold: Threshold = None
    min_width: Width = None
    max_width: Width = None
    choice: Choice = PeakOption.CONTINUITY
    smoothing: Smoothing = 0.0
    mask: MaskFile = None
    colour: Colour = None
    bayer: Bayer = None

    @property
    def files(self) -> tuple[Path, ...]:
        """The files that are read."""
        return () if self.mask is None else (self.mask,)

    @property
    def channel(self) -> "Channel | None":
        """What of colour or raw pictures is measured."""
        return choose_channel(self.colour, self.bayer)

    def settings(self) -> "LineSettings":
        """What is set, with the mask read.

        Raises:
            OperationError: the mask cannot be read.
        """
        from crenel.formats.settings.line_settings import LineSettings
        from crenel.formats.settings.mask import Mask
        from crenel.metrology.stripe import StripeSettings

        stripe = StripeSettings(
            self.threshold,
            self.min_width,
            self.max_width,
            choice=self.choice.value,
            smoothing_px=self.smoothing,
        )
        mask = None if self.mask is None else Mask.read(self.mask)
        return LineSettings(stripe, mask, self.channel)


def choose_channel(colour: ColourOption | None, bayer: BayerOption | None) -> "Channel | None":
    """What of the pictures is measured; raises ``BadParameter`` for raw ones of no colour."""
    from crenel.metrology.bayer import BayerPlane

    if bayer is None:
        return None if colour is None else colour.value
    if colour is None:
        raise typer.BadParameter("--bayer needs the laser's --colour")
    return BayerPlane(bayer.value, colour.value)


def takes_line_options(
    *without: str,
) -> Callable[[Callable[..., None]], Callable[..., None]]:
    """A command whose parameter ``line`` is ``LineOptions`` gets these as its options.

    Args:
        without: fields that the command does not have as options.
    """

    def with_options(command: Callable[..., None]) -> Callable[..., None]:
        asked = inspect.signature(LineOptions, eval_str=True).parameters
        options = {name: one for name, one in asked.items() if name not in without}

        @wraps(command)
        def run(**given: Any) -> None:
            of_line: Mapping[str, Any] = {name: given.pop(name) for name in options}
            command(**given, line=LineOptions(**of_line))

        signature = inspect.signature(command, eval_str=True)
        parameters: list[inspect.Parameter] = []
        for one in signature.parameters.values():
            kept = one.replace(kind=inspect.Parameter.KEYWORD_ONLY)
            of_line = [o.replace(kind=kept.kind) for o in options.values()]
            parameters += of_line if one.name == "line" else [kept]
        run.__signature__ = signature.replace(parameters=parameters)  # type: ignore[attr-defined]
        run.__annotations__ = {one.name: one.annotation for one in parameters} | {"return": None}
        return run

    return with_options
