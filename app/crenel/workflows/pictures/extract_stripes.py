"""Stripes of pictures as a table."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import cast

import numpy as np

from crenel.errors import OperationError
from crenel.formats.atomic_write import write_atomically
from crenel.formats.csv_table import table_text
from crenel.formats.file_names import display_path
from crenel.formats.images import (
    GreyImage,
    describe_grey,
    read_colours,
    read_grey,
    read_image,
    select_grey,
)
from crenel.formats.settings.line_settings import AUTOMATIC_LINE, LineSettings, cell_px
from crenel.messages.message import Text, message, quantity
from crenel.metrology.bayer import CELL_PX, BayerPlane
from crenel.metrology.channel import Channel, is_grey, select_channel
from crenel.metrology.colour import Colours, LaserColour, find_weights
from crenel.metrology.image import saturation_level
from crenel.metrology.mosaic import shows_mosaic
from crenel.metrology.stripe import (
    ONE_OF_TWO,
    FoundLine,
    LaserAlone,
    LineEvidence,
    LineSearch,
    Stripe,
    check_settings,
    empty_stripe,
    has_second_line,
    shows_two_lasers,
    take_off_room_light,
)
from crenel.progress import Progress, no_progress
from crenel.workflows.pictures.colour_pictures import extract_by_colour, is_by_colour

MANY_CLIPPED, DARK = 0.3, 0.1
"""Shares of the pixels, and of full scale, from which a picture is reported as such."""
SPARSE, FAR_MORE = 0.5, 2.0
"""Share of the columns below which the line may run along the other axis, and by how many times
its points are then more."""
COLUMNS = ("u", "v", "intensity", "sigma_px")
NOT_FOUND, OTHER_AXIS = "stripe-not-found", "stripe-along-other-axis"
"""Codes of refusals: a picture that could be read shows no line along the axis."""


@dataclass(frozen=True)
class ImageStripe:
    """The stripe in one picture file, or the reason why there is none."""

    file: Path
    stripe: Stripe
    """Without points if there is a refusal."""
    channel: Text = ""
    """What of the picture was measured, in words."""
    width_px: float = 0.0
    """The line's usual width at half height; 0 if it is clipped."""
    rows_made_one: float = 1.0
    """Rows of the picture that were made one to find the line."""
    refusal: OperationError | None = None
    other_axis_points: int = 0
    """Points along the other axis, where there are far more of them."""
    two_lines: bool = False
    """A second line runs beside the first, and the points may jump between them."""
    looks_raw: bool = False
    """The pixels alternate as in a raw picture of a colour camera, but were measured as grey."""
    shown: Channel | None = None
    """The channel in which the line is to be seen."""
    why: LineEvidence | None = None
    """What took its pieces, and left others; where that was asked for."""


def extract_stripes(
    images: Sequence[Path],
    axis: str,
    progress: Progress = no_progress,
    line: LineSettings = AUTOMATIC_LINE,
    *,
    explains: bool = False,
) -> list[ImageStripe]:
    """The stripe of every picture, outside the zones of a mask, each by itself.

    A picture that cannot be read, has no stripe, or differs in size from the mask is listed with
    this refusal.

    Args:
        line: what is set of the line.
        explains: says what took the pieces of grey lines, and left others, too.

    Raises:
        OperationError: the settings contradict each other.
    """
    check_settings(line.stripe)
    found: list[ImageStripe] = []
    for done, path in enumerate(images):
        progress(done / len(images), path.name)
        try:
            seen = extract_file(path, axis, line)
        except OperationError as refusal:
            seen = ImageStripe(path, empty_stripe(axis), refusal=refusal)
        found.append(_explain(seen, axis, line) if explains else seen)
    progress(1.0, "")
    return found


def _explain(seen: ImageStripe, axis: str, line: LineSettings) -> ImageStripe:
    """The same with what decided about the line on the picture's grey levels, if it has any."""
    try:
        picture = read_grey(seen.file, line.channel)
    except OperationError:
        return seen
    search, shown = line.search(line.channel), _laser_alone(picture, line)
    why = search.explain(shown, axis, search.find(shown, axis)).why
    if why is not None and isinstance(line.channel, BayerPlane):
        offset_px = line.channel.offset_px if axis == "u" else line.channel.offset_px[::-1]
        along, across = CELL_PX * why.along, CELL_PX * why.across
        why = replace(why, along=along + offset_px[0], across=across + offset_px[1])
    return replace(seen, why=why)


def extract_file(
    path: Path,
    axis: str,
    line: LineSettings,
    looks_for_two: bool = True,
) -> ImageStripe:
    """The stripe of a picture, and whether another line is beside it.

    Raises:
        OperationError: the picture cannot be measured, or has no stripe.
    """
    image, channel = read_image(path), line.channel
    line.check_size(path, image.shape[1], image.shape[0])
    if line.unlit is None and is_by_colour(line.stripe, channel) and not is_grey(image):
        return _extract_colours(path, image, axis, line)
    picture = select_grey(image, display_path(path), channel)
    search = line.search(channel)
    shown = _laser_alone(picture, line)
    seen = _extract(shown, axis, search, channel)
    found, other = len(seen.stripe.u), 0
    looks_raw = is_unstated_raw(picture, channel)
    if found < SPARSE * picture.shape[1 if axis == "u" else 0]:
        other = len(_extract(shown, other_axis(axis), search, channel).stripe.u)
    if not found:
        raise _no_stripe_error(path, picture, axis, line.mask is not None, other, looks_raw)
    text = describe_grey(image, channel)
    if shown.is_difference:
        text = message("channel-less-laser-off", channel=text)
    width_px = cell_px(channel) * seen.width_px
    other = other if other > FAR_MORE * found else 0
    looks_for_two &= not (isinstance(channel, BayerPlane) or line.stripe.choice in ONE_OF_TWO)
    return ImageStripe(
        path,
        seen.stripe,
        text,
        width_px,
        seen.factor,
        other_axis_points=other,
        two_lines=looks_for_two and has_second_line(shown.image, seen, search.where),
        looks_raw=looks_raw,
        shown=channel,
    )


def _extract_colours(
    path: Path,
    picture: Colours,
    axis: str,
    line: LineSettings,
) -> ImageStripe:
    """The stripe of a colour picture; errors are those of ``extract_file``."""
    search, colour = line.search(), cast(LaserColour | None, line.channel)
    seen = extract_by_colour(picture, axis, search, colour)
    found, other = 0 if seen is None else len(seen.found.stripe.u), 0
    if found < SPARSE * picture.shape[1 if axis == "u" else 0]:
        beside = extract_by_colour(picture, other_axis(axis), search, colour)
        other = 0 if beside is None else len(beside.found.stripe.u)
    if seen is None or not found:
        grey = select_channel(picture, colour or "green")
        assert grey is not None
        raise _no_stripe_error(path, grey, axis, line.mask is not None, other, False)
    return ImageStripe(
        path,
        seen.found.stripe,
        seen.text,
        seen.found.width_px,
        seen.found.factor,
        other_axis_points=other if other > FAR_MORE * found else 0,
        shown=seen.channel,
    )


def _laser_alone(picture: GreyImage, line: LineSettings) -> LaserAlone:
    """The picture in which the line is looked for: less what it shows with the laser off."""
    return LaserAlone(picture) if line.unlit is None else take_off_room_light(picture, line.unlit)


def is_unstated_raw(picture: GreyImage, channel: Channel | None) -> bool:
    """Whether a picture that is measured as grey looks like a raw one of a colour camera."""
    return not isinstance(channel, BayerPlane) and shows_mosaic(picture)


def other_axis(axis: str) -> str:
    """``v`` of ``u``, and the other way round."""
    return "v" if axis == "u" else "u"


def _extract(
    picture: LaserAlone, axis: str, search: LineSearch, channel: Channel | None
) -> FoundLine:
    """The stripe in pixels of the file's picture; its width in those that were measured."""
    line = search.find(picture, axis)
    line = replace(line, stripe=picture.in_levels(line.stripe))
    if not isinstance(channel, BayerPlane):
        return line
    return replace(line, stripe=channel.raw_stripe(line.stripe))


def describe_two_lasers(two_lines: Sequence[bool]) -> Text:
    """What is to be said of pictures with a line, True where there are two; empty of one laser."""
    if not shows_two_lasers(two_lines):
        return ""
    return message("two-lines-in-pictures", two=sum(two_lines), of=len(two_lines))


def with_laser_off(line: LineSettings, lit: Path, unlit: Path) -> LineSettings:
    """The settings for pictures of one place, of which there is one with the laser off, too.

    Its difference from the first one weighs the channels of colour pictures. Grey ones are measured
    less what they show with the laser off.

    Args:
        lit: the first picture with the laser on.

    Raises:
        OperationError: a picture cannot be read, or as ``find_weights``.
    """
    with_laser, without = read_colours(lit), read_colours(unlit)
    if with_laser is None or without is None:
        return replace(line, unlit=read_grey(unlit, line.channel))
    return replace(line, channel=find_weights(with_laser, without))


def _no_stripe_error(
    path: Path,
    picture: GreyImage,
    axis: str,
    masked: bool,
    other_axis_points: int,
    looks_raw: bool,
) -> OperationError:
    """With the line along the other axis, or the properties of the picture, instead."""
    what = message("shows-no-stripe", path=display_path(path))
    if masked:
        what = message("shows-no-stripe-outside-mask", path=display_path(path))
    if other_axis_points:
        why = message("line-along-other-axis", axis=axis, points=other_axis_points)
        return OperationError(OTHER_AXIS, what, why, message("give-axis", axis=other_axis(axis)))
    if looks_raw:
        why = message("pixels-alternate-as-raw")
        return OperationError(NOT_FOUND, what, why, message("state-bayer"))
    full = saturation_level(picture)
    clipped = float(np.mean(picture >= full))
    brightest = int(picture.max())
    if clipped > MANY_CLIPPED:
        why = message("overexposed-share-at-full-scale", share=quantity(100 * clipped, "%"))
        return OperationError(NOT_FOUND, what, why, message("shorten-exposure-or-darken-room"))
    if brightest < DARK * full:
        why = message("dark-brightest-pixel", brightest=brightest, full=quantity(full))
        return OperationError(NOT_FOUND, what, why, message("laser-on-or-expose-longer"))
    why = message("no-bright-line-runs", axis=axis)
    remedy = message("take-with-laser-or-describe-line")
    return OperationError(NOT_FOUND, what, why, remedy)


def write_stripes(path: Path, stripes: Sequence[ImageStripe]) -> None:
    """Writes ``u,v,intensity,sigma_px``; for several pictures, with a last column ``image``, also
    if only one of them has a stripe."""
    several = len(stripes) > 1
    rows: list[tuple[float | str, ...]] = []
    for picture in stripes:
        stripe = picture.stripe
        mark = (str(picture.file),) if several else ()
        columns = (stripe.u, stripe.v, stripe.intensity, stripe.sigma_px)
        points = zip(*(column.tolist() for column in columns), strict=True)
        rows.extend((*point, *mark) for point in points)
    text = table_text((*COLUMNS, "image") if several else COLUMNS, rows)
    write_atomically(path, text.encode())
