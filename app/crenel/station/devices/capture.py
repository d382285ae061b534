"""Takes the calibration pictures: ambient and laser, while the arm is held still."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Literal

from crenel.errors import OperationError
from crenel.messages.message import message, quantity
from crenel.station.devices.frame_hub import FrameHub
from crenel.station.devices.reading_buffer import ReadingMean
from crenel_hardware.clock import now_ns
from crenel_hardware.interfaces import Frame, Line, SensorReading

FRAME_TIMEOUT_S = 3.0
# The joints are averaged over at least this long, whatever the exposure.
SHORTEST_MEAN_NS = 200_000_000
MeanOver = Callable[[int, int], ReadingMean]
SwitchLaser = Callable[[bool], None]


Lighting = Literal["pair", "both", "ambient"]
"""``both`` in one picture if the sensor has no laser switch; ``ambient`` alone if the laser did
not switch on, and it may be missing."""


@dataclass(frozen=True)
class Capture:
    """One pose of the sensor: its picture or pictures, and the mean joints of the arm."""

    ambient: Frame
    laser: Frame | None
    lighting: Lighting
    joints: ReadingMean


def capture(
    hub: FrameHub,
    set_laser: SwitchLaser | None,
    laser_was_on: bool,
    mean_over: MeanOver,
    needs_laser: bool = True,
) -> Capture:
    """Takes a pair of pictures (or one), then checks that the arm was still.

    Args:
        set_laser: switches the laser; None if the sensor has no switch.
        mean_over: mean of the joints between two time stamps; raises ``OperationError`` if the
            arm moved between them.
        needs_laser: without a picture with the laser on, there is none at all.

    Raises:
        OperationError: no frame arrived, the laser did not switch, or the arm moved.
    """
    if set_laser is None:
        frame = _wait_for_frame(hub, now_ns(), None)
        closed_ns = _exposure_end_ns(frame)
        joints = mean_over(min(_exposure_start_ns(frame), closed_ns - SHORTEST_MEAN_NS), closed_ns)
        return Capture(frame, None, "both", joints)
    try:
        set_laser(False)
        ambient = _wait_for_frame(hub, now_ns(), False)
        laser = _take_lit(hub, set_laser, needs_laser)
    finally:
        set_laser(laser_was_on)
    closed_ns = _exposure_end_ns(ambient if laser is None else laser)
    joints = mean_over(min(_exposure_start_ns(ambient), closed_ns - SHORTEST_MEAN_NS), closed_ns)
    return Capture(ambient, laser, "ambient" if laser is None else "pair", joints)


def no_pictures_error() -> OperationError:
    """The error for a sensor that sends lines where a picture is needed."""
    return OperationError(
        "no-pictures",
        message("sensor-sends-lines-no-pictures"),
        message("this-needs-pictures"),
        message("set-sensor-send-pictures"),
    )


def _take_lit(hub: FrameHub, set_laser: SwitchLaser, needed: bool) -> Frame | None:
    """A picture with the laser on; None if it does not switch on, and is not needed."""
    try:
        set_laser(True)
        return _wait_for_frame(hub, now_ns(), True)
    except OperationError as error:
        if needed or error.code != "laser-stuck":
            raise
        return None


def _exposure_start_ns(frame: SensorReading) -> int:
    return frame.mid_exposure_ns - int(500 * frame.exposure_us)


def _exposure_end_ns(frame: Frame) -> int:
    return frame.mid_exposure_ns + int(500 * frame.exposure_us)


def _wait_for_frame(hub: FrameHub, switched_ns: int, laser_on: bool | None) -> Frame:
    """The next frame whose exposure was entirely after the switch, with the laser as requested."""
    frame = hub.wait(
        lambda f: _exposure_start_ns(f) >= switched_ns and laser_on in (None, f.laser_on),
        FRAME_TIMEOUT_S,
    )
    if frame is not None:
        return frame
    latest = hub.latest
    if latest is not None and _exposure_start_ns(latest) >= switched_ns:
        raise OperationError(
            "laser-stuck",
            message(
                "no-picture-laser-came-within",
                state="on" if laser_on else "off",
                limit=quantity(FRAME_TIMEOUT_S, "s"),
            ),
            message("sensor-reports-laser-other-state"),
            message("check-lasers-interlock-key-switch-capture"),
        )
    newest = hub.newest
    if isinstance(newest, Line) and _exposure_start_ns(newest) >= switched_ns:
        raise no_pictures_error()
    raise OperationError(
        "sensor-lost",
        message("no-picture-came-within", limit=quantity(FRAME_TIMEOUT_S, "s")),
        message("sensor-lost-exposure-longer-than"),
        message("wait-until-sensor-connected-capture-again"),
    )
