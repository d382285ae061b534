"""Messages about frames, joints and clocks from which no points could be reconstructed."""

from collections.abc import Sequence
from pathlib import Path
from typing import Literal

from crenel.errors import OperationError
from crenel.formats.file_names import display_path
from crenel.formats.recording.ordering.clock_check import ClockReport
from crenel.formats.recording.pose_samples import FirstImplausible
from crenel.formats.recording.reading_track import ReadingTrack
from crenel.messages.message import Quantity, Text, join, message, quantity, rounded
from crenel.metrology.sensor.line_thinning import LINES_AT_A_PLACE
from crenel.metrology.stripe import HALF_HEIGHT_PERIOD

Stream = Literal["joints", "frames"]


def missing_joints_warning(
    unplaced_ns: Sequence[int],
    at_ns: Sequence[int],
    frames: int,
    track: ReadingTrack,
    start_ns: int,
) -> Text:
    """Frames without joints around their time stamps, among a number of frames.

    ``at_ns``: the stamps by the arm's clock.
    """
    first_ns, last_ns = track.first_ns or 0, track.last_ns or 0
    beyond = sum(not first_ns <= one <= last_ns for one in at_ns)
    return message(
        "frames-left-out-no-joints-around",
        count=len(unplaced_ns),
        frames=frames,
        first=_seconds(unplaced_ns[0] - start_ns),
        beyond=beyond,
        gaps=len(unplaced_ns) - beyond,
    )


def implausible_joints_warning(count: int, first: FirstImplausible, start_ns: int) -> Text:
    """Impossible joint samples."""
    return message(
        "joint-samples-left-out-cannot-true",
        count=count,
        first=_seconds(first.stamp_ns - start_ns),
        error=first.error.text,
    )


def clock_warnings(stream: Stream, clock: ClockReport, start_ns: int) -> list[Text]:
    """Gaps in a stream, and jumps of its clock."""
    warnings: list[Text] = []
    if clock.holes:
        warnings.append(
            message(
                "about-missing-places-longest-start",
                stream=stream,
                missing=clock.missing,
                holes=clock.holes,
                longest=_gap(clock.longest_ns),
                at=_seconds(clock.longest_at_ns - start_ns),
            )
        )
    if clock.jumps:
        warnings.append(
            message(
                "clock-jumps-times-first-start-points",
                stream=stream,
                jumps=clock.jumps,
                first=_seconds(clock.first_jump_at_ns - start_ns),
            )
        )
    return warnings


def smoothing_warning(smoothing_px: float) -> Text:
    """The station smoothed the stripes along the line before it recorded them."""
    return message(
        "stripes-were-smoothed",
        smoothing=rounded(smoothing_px, "px"),
        half=rounded(HALF_HEIGHT_PERIOD * smoothing_px, "px", 3),
    )


def still_lines_warning(still: int, frames: int) -> Text:
    """Frames of a line that stood still, among a number of frames."""
    return message("still-lines-left-out", count=still, frames=frames, most=LINES_AT_A_PLACE)


def incomplete_error(path: Path, missing: Text, causes: Sequence[Text]) -> OperationError:
    """So much of a scan is missing that it is refused."""
    return OperationError(
        "scan-incomplete",
        message("scan-is-missing-parts", path=display_path(path), missing=missing),
        join(causes, "; "),
        message("scan-incomplete-remedy"),
    )


def no_joints_error(
    named: Text, unplaced_ns: Sequence[int], track: ReadingTrack, start_ns: int
) -> OperationError:
    """No frame has joints around its time stamp."""
    return OperationError(
        "no-joints-around-frames",
        message("no-joints-around-any-frames-stamp", named=named),
        message(
            "frames-joint-samples-which-neighbours-up",
            frames_from=_seconds(unplaced_ns[0] - start_ns),
            frames_to=_seconds(unplaced_ns[-1] - start_ns),
            joints_from=_seconds((track.first_ns or 0) - start_ns),
            joints_to=_seconds((track.last_ns or 0) - start_ns),
            gap=quantity(track.gap_limit_ns / 1e6, "ms"),
        ),
        message("scan-again-arm-camera-one-clock"),
    )


def _gap(ns: int) -> Quantity:
    """A duration in ms, or from one second on in s."""
    return (
        quantity(ns / 1e9, "s", 1) if ns >= 1e9 else quantity(ns / 1e6, "ms", 1 if ns < 1e7 else 0)
    )


def _seconds(ns: int) -> Quantity:
    return quantity(ns / 1e9, "s", 3)
