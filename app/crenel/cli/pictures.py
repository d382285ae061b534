"""The command line's part for single pictures: ``extract`` and ``detect``."""

from dataclasses import replace
from enum import StrEnum
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from crenel.cli.line_options import (
    Bayer,
    Colour,
    ColourOption,
    LineOptions,
    choose_channel,
    takes_line_options,
)
from crenel.console import (
    AsJson,
    fail_if_left_out,
    print_json,
    print_table,
    progress_bar,
    report_errors,
    warn,
)

if TYPE_CHECKING:
    from crenel.errors import OperationError
    from crenel.workflows.pictures.detect_targets import ImageDetection
    from crenel.workflows.pictures.extract_stripes import ImageStripe


class Axis(StrEnum):
    """Along which image axis stripe points are counted."""

    U = "u"
    V = "v"


Draw = Annotated[
    Path | None,
    typer.Option(
        help="Also write each picture with what was found on it, and of a grey line what took its"
        " pieces and left others.",
        file_okay=False,
    ),
]


@report_errors
@takes_line_options()
def extract(
    images: Annotated[list[Path], typer.Argument(help="Pictures with the laser on.")],
    output: Annotated[Path, typer.Option("-o", "--output", help="Where to write it.")] = Path(
        "stripe.csv"
    ),
    axis: Annotated[
        Axis, typer.Option(help="u: one point a column of the picture; v: one a row.")
    ] = Axis.U,
    *,
    line: LineOptions,
    laser_off: Annotated[
        Path | None,
        typer.Option(
            help="The first picture with the laser off. Its difference weighs the channels of"
            " colour pictures, instead of --colour; grey ones are measured less it, where nothing"
            " moved."
        ),
    ] = None,
    calibration: Annotated[
        Path | None,
        typer.Option(
            help="calibration.json of the sensor: the line is looked for where its plane and the"
            " calibrated distances show it, and somewhat beyond."
        ),
    ] = None,
    draw: Draw = None,
    as_json: AsJson = False,
) -> None:
    """Extract the laser stripe: columns u, v, intensity, sigma_px.

    Of several pictures, a last column ``image`` names the picture of each row. Each picture is
    listed with its points or the reason why it has none. Exits with status 3 if some pictures have
    no line, and with status 1, without a file, if none has one.
    """
    from crenel.formats.atomic_write import check_output_path
    from crenel.formats.images import read_grey_to_show
    from crenel.formats.results.calibration import read_calibration
    from crenel.workflows.pictures.draw_pictures import draw_stripe, write_drawings
    from crenel.workflows.pictures.extract_stripes import (
        describe_two_lasers,
        with_laser_off,
        write_stripes,
    )
    from crenel.workflows.pictures.extract_stripes import extract_stripes as extract_all

    beside = () if calibration is None else (calibration,)
    check_output_path(output, [*images, *line.files, *beside])
    settings = line.settings()
    if calibration is not None:
        settings = replace(
            settings, bounds=read_calibration(calibration).find_line_bounds(axis.value)
        )
    if laser_off is not None:
        if settings.channel is not None:
            raise typer.BadParameter("--laser-off takes the place of --colour and --bayer")
        settings = with_laser_off(settings, images[0], laser_off)
    with progress_bar("Extracting", not as_json) as progress:
        explains = draw is not None
        stripes = extract_all(images, axis.value, progress, settings, explains=explains)
        lines = [one for one in stripes if one.refusal is None]
        if draw is not None:
            drawings = (
                (one.file, draw_stripe(read_grey_to_show(one.file, one.shown), one.stripe, one.why))
                for one in stripes
                if one.refusal is None or one.why is not None
            )
            write_drawings(draw, drawings)
        if len(images) == 1 and stripes[0].refusal is not None:
            raise stripes[0].refusal
        if lines:
            write_stripes(output, stripes)
    if as_json:
        file = str(output) if lines else None
        pictures = list(map(_stripe_fields, stripes))
        print_json({"file": file, "axis": axis.value, "images": pictures})
    else:
        _print_stripes(stripes)
        if lines:
            print(f"{output} written")
    _warn_of_axis(axis, stripes)
    _warn_of_raw(sum(one.looks_raw for one in lines))
    if two := describe_two_lasers([one.two_lines for one in lines]):
        warn(two)
    without, of = len(stripes) - len(lines), len(stripes)
    _fail_if_without(without, of, "line")


def _fail_if_without(without: int, of: int, what: str) -> None:
    """Ends the command if pictures are without what was looked for."""
    none = f"none of the {of} pictures has any" if of > 1 else "the picture has no"
    some = f"{without} of {of} pictures have no {what}"
    fail_if_left_out(without, of, f"{none} {what}: nothing written", some)


def _warn_of_axis(axis: Axis, stripes: "list[ImageStripe]") -> None:
    """Says so if the lines run along the other axis."""
    from crenel.messages.message import message
    from crenel.workflows.pictures.extract_stripes import other_axis

    steep = [one for one in stripes if one.other_axis_points]
    if steep:
        found = sum(len(one.stripe.u) for one in steep)
        other = sum(one.other_axis_points for one in steep)
        warn(
            message(
                "lines-along-other-axis",
                pictures=len(steep),
                axis=axis.value,
                found=found,
                better=other_axis(axis.value),
                other=other,
            )
        )


def _warn_of_raw(pictures: int) -> None:
    """Says so if pictures that were measured as grey look like raw ones of a colour camera."""
    if pictures:
        warn(
            f"in {pictures} pictures, the pixels alternate as in a raw picture of a colour camera,"
            " but were measured as grey. State --bayer and --colour"
        )


def _refusal_fields(refusal: "OperationError | None") -> dict[str, str] | None:
    """Why a picture is refused, for programs."""
    return None if refusal is None else {"code": refusal.code, "text": refusal.line}


def _stripe_fields(found: "ImageStripe") -> dict[str, object]:
    """A picture's stripe, or why there is none, for programs."""
    return {
        "image": str(found.file),
        "channel": str(found.channel),
        "width_px": found.width_px or None,
        "rows_made_one": found.rows_made_one,
        "u": found.stripe.u.tolist(),
        "v": found.stripe.v.tolist(),
        "intensity": found.stripe.intensity.tolist(),
        "sigma_px": found.stripe.sigma_px.tolist(),
        "other_axis_points": found.other_axis_points or None,
        "two_lines": found.two_lines,
        "looks_raw": found.looks_raw,
        "refusal": _refusal_fields(found.refusal),
    }


def _print_stripes(stripes: "list[ImageStripe]") -> None:
    """A row for each picture, then the reasons of those without a line."""
    import numpy as np

    rows = [
        (str(one.file), "none", "", "", "", "")
        if one.refusal is not None
        else (
            str(one.file),
            str(len(one.stripe.u)),
            f"{float(np.median(one.stripe.sigma_px)):.3f}",
            f"{one.width_px:.1f}" if one.width_px else "clipped",
            f"{one.rows_made_one:g}",
            str(one.channel),
        )
        for one in stripes
    ]
    columns = ("picture", "points", "median σ px", "width px", "rows made one", "channel")
    print_table("Laser stripe", columns, rows)
    for one in stripes:
        if one.refusal is not None:
            print(one.refusal.line)  # it names the picture


@report_errors
def detect(
    images: Annotated[list[Path], typer.Argument(help="Pictures of the calibration object.")],
    target: Annotated[
        Path, typer.Option("--object", help="object.json: the block or board by its certificate.")
    ],
    output: Annotated[
        Path | None, typer.Option("-o", "--output", help="Write the corners here, as CSV.")
    ] = None,
    laser: Annotated[
        Axis | None, typer.Option(help="The laser is on in the pictures; its stripe's axis.")
    ] = None,
    colour: Colour = None,
    bayer: Bayer = None,
    draw: Draw = None,
    as_json: AsJson = False,
) -> None:
    """Show what is seen of a block or a board in pictures: corners, or why none.

    The file has the columns image, number, u, v, sigma_px, refusal. Exits with status 3 if some
    pictures have no corners, and with status 1, without a file, if none has any.
    """
    from crenel.formats.atomic_write import check_output_path
    from crenel.formats.datasheets.target import read_object
    from crenel.formats.images import read_grey_to_show
    from crenel.workflows.pictures.detect_targets import detect_targets, write_detections
    from crenel.workflows.pictures.draw_pictures import draw_detection, write_drawings

    if output is not None:
        check_output_path(output, [*images, target])
    # a colour camera has most pixels of green
    channel = choose_channel(ColourOption.GREEN if colour is None else colour, bayer)
    with progress_bar("Detecting", not as_json) as progress:
        found = detect_targets(
            images, read_object(target), laser.value if laser else None, channel, progress
        )
        unreadable = [one.refusal for one in found if one.refusal and not one.readable]
        if len(unreadable) == len(found):
            raise unreadable[0]
        shown = [one for one in found if one.refusal is None]
        written = output if shown else None
        if written is not None:
            write_detections(written, found)
        if draw is not None:
            drawings = (
                (one.file, draw_detection(read_grey_to_show(one.file, channel), one))
                for one in found
                if one.readable
            )
            write_drawings(draw, drawings)
    if as_json:
        pictures = [
            {
                "image": str(one.file),
                "corners": [vars(corner) for corner in one.corners],
                "looks_raw": one.looks_raw,
                "refusal": _refusal_fields(one.refusal),
            }
            for one in found
        ]
        print_json({"images": pictures})
    else:
        _print_detections(target, found)
        if written is not None:
            print(f"{written} written")
    _warn_of_raw(sum(one.looks_raw for one in shown))
    without, of = len(found) - len(shown), len(found)
    _fail_if_without(without, of, "corners")


def _print_detections(target: Path, found: "list[ImageDetection]") -> None:
    """A row for each picture, then the reasons of those without corners."""
    rows = [(str(one.file), str(len(one.corners) or "none")) for one in found]
    print_table(f"Corners of {target}", ("picture", "corners"), rows)
    for one in found:
        if one.refusal is not None:
            named = f"{one.file}: " if one.readable else ""  # else the reason names it
            print(f"{named}{one.refusal.line}")
