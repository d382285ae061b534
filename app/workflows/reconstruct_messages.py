"""What is said of frames, joints and clocks that a rebuilt cloud could not be made of."""

from collections.abc import Sequence

from app.errors import OperationError
from app.formats.recording.clock_check import ClockReport
from app.formats.recording.joint_track import JointTrack
from app.metrology.arm.joint_plausibility import ImplausibleReading


def missing_joints_warning(
    unplaced_ns: Sequence[int], frames: int, track: JointTrack, delay_ns: int, start_ns: int
) -> str:
    """Of so many frames, those without joints around their stamps."""
    first_ns, last_ns = track.first_ns or 0, track.last_ns or 0
    at_ns = [stamp_ns + delay_ns for stamp_ns in unplaced_ns]
    beyond = sum(not first_ns <= one <= last_ns for one in at_ns)
    return (
        f"{len(unplaced_ns)} of {frames} frames left out: no joints around their stamps, the "
        f"first {(unplaced_ns[0] - start_ns) / 1e9:.3f} s from the start; {beyond} before the "
        f"first or after the last sample, {len(unplaced_ns) - beyond} in gaps"
    )


def implausible_joints_warning(count: int, first: ImplausibleReading, start_ns: int) -> str:
    """Of joint samples that cannot be true."""
    return (
        f"{count} joint samples left out that cannot be true, the first "
        f"{(first.stamp_ns - start_ns) / 1e9:.3f} s from the start: {first.error.line}"
    )


def clock_warnings(title: str, clock: ClockReport, start_ns: int) -> list[str]:
    """Of holes in a stream, and of jumps of its clock."""
    said = []
    if clock.holes:
        said.append(
            f"about {clock.missing} {title} are missing in {clock.holes} places, the "
            f"longest {clock.longest_ns / 1e6:.1f} ms, "
            f"{(clock.longest_at_ns - start_ns) / 1e9:.3f} s from the start"
        )
    if clock.jumps:
        said.append(
            f"the clock of the {title} jumps {clock.jumps} times, first to "
            f"{(clock.first_jump_at_ns - start_ns) / 1e9:.3f} s from the start; points "
            "near a jump may be out of place"
        )
    return said


def no_joints_error(
    named: str, unplaced_ns: Sequence[int], track: JointTrack, start_ns: int
) -> OperationError:
    """Where no frame at all has joints around its stamp."""

    def span(first_ns: int, last_ns: int) -> str:
        return f"from {(first_ns - start_ns) / 1e9:.3f} to {(last_ns - start_ns) / 1e9:.3f} s"

    return OperationError(
        "no-joints-around-frames",
        f"{named}: no joints around any frame's stamp",
        f"frames {span(unplaced_ns[0], unplaced_ns[-1])}, joint samples "
        f"{span(track.first_ns or 0, track.last_ns or 0)}, of which neighbours up to "
        f"{track.gap_limit_ns / 1e6:.0f} ms apart are used",
        "Scan again, with arm and camera on one clock",
    )
