"""Which arm a station expects at a line, and what the driver refuses about an arm's hello."""

from math import pi
from typing import Annotated

from pydantic import Field, PositiveInt

from crenel.messages.message import message
from crenel_hardware.arm.protocol import BUTTON_BITS, Hello
from crenel_hardware.errors import DeviceError
from crenel_hardware.interfaces import ArmInfo
from crenel_hardware.options import Options, Shown
from crenel_hardware.shared_options import ArmLatency, Baudrate, TimeoutSeconds, Url

JOINT_COUNTS = (5, 6, 7)


class SerialEncoderOptions(Options):
    """Options of the driver in station.toml."""

    title = message("driver-bridge")
    usual = True
    url: Url
    baudrate: Baudrate = 921_600
    joint_count: Annotated[
        int | None,
        Field(ge=JOINT_COUNTS[0], le=JOINT_COUNTS[-1]),
        Shown(message("option-joint-count")),
    ] = None
    counts_per_revolution: Annotated[
        PositiveInt | list[PositiveInt] | None, Shown(message("option-counts-per-revolution"))
    ] = None
    setting: Annotated[
        int | None,
        Field(ge=0, le=0xFFFFFFFF),
        Shown(message("option-setting"), message("option-help-setting")),
    ] = None
    latency_us: ArmLatency = 0.0
    timeout_s: TimeoutSeconds = 3.0


def arm_info(hello: Hello) -> ArmInfo:
    """The properties of an arm from its hello."""
    return ArmInfo(
        name=hello.name or ("bridge" if hello.reports_poses else "encoder arm"),
        serial_number=hello.serial_number,
        joint_count=0 if hello.reports_poses else len(hello.counts_per_revolution),
        rate_hz=hello.rate_hz,
        reports="pose" if hello.reports_poses else "joints",
        pose_of="tool" if hello.poses_of_tool else "flange",
        buttons=frozenset(button for bit, button in BUTTON_BITS if hello.buttons & bit),
        stamps="arrival" if hello.stamps_arrival else "device",
        free_running=not hello.only_changes,
        pulses_hz=hello.pulses_hz,
    )


def refuse_other_arm(options: SerialEncoderOptions, hello: Hello) -> None:
    """Raises ``DeviceError`` for an arm that is not the one of station.toml."""
    joints = len(hello.counts_per_revolution)
    if not hello.reports_poses and joints not in JOINT_COUNTS:
        raise DeviceError(
            message("arm-reports-joints", url=options.url, joints=joints),
            message("arms-5-6-7-joints-served"),
        )
    if options.joint_count not in (None, 0 if hello.reports_poses else joints):
        raise DeviceError(
            message(
                "arm-has-joints-station-toml-asks",
                url=options.url,
                name=hello.name,
                serial_number=hello.serial_number,
                joints=joints,
                joint_count=options.joint_count,
            ),
            message("plug-right-arm-correct-arm-joint"),
        )
    if hello.reports_poses and options.setting not in (None, hello.setting):
        raise setting_error(options.url, hello.setting, options.setting)


def setting_error(url: str, setting: int, expected: int) -> DeviceError:
    """The poses are in other frames than expected: nothing measured with them would be right."""
    return DeviceError(
        message("arm-poses-other-setting", url=url, setting=str(setting), expected=str(expected)),
        message("restore-tool-and-coordinate-system"),
    )


def another_arm_error(url: str, hello: Hello, expected: Hello) -> DeviceError:
    """Another arm took the place of the one that was opened."""
    return DeviceError(
        message(
            "another-arm-answers",
            url=url,
            name=hello.name,
            serial_number=hello.serial_number,
            joints=len(hello.counts_per_revolution),
            expected_name=expected.name,
            expected_serial_number=expected.serial_number,
        ),
        message("check-which-arm-plugged"),
    )


def radians_per_count(options: SerialEncoderOptions, hello: Hello) -> tuple[float, ...]:
    """(n,) of each joint; empty for poses; raises ``DeviceError`` if the counts are unusable."""
    joints, given = len(hello.counts_per_revolution), options.counts_per_revolution
    if hello.reports_poses:
        return ()
    if given is None:
        counts = hello.counts_per_revolution
    else:
        counts = tuple(given) if isinstance(given, list) else (given,) * joints
    if len(counts) != joints:
        raise DeviceError(
            message("station-toml-gives-counts-per-revolution", counts=len(counts), joints=joints),
            message("give-one-number-all-joints-one"),
        )
    if 0 in counts:
        raise DeviceError(
            message(
                "arm-reports-no-counts-per-revolution", url=options.url, joint=counts.index(0) + 1
            ),
            message("set-arm-counts-per-revolution-station"),
        )
    return tuple(2 * pi / count for count in counts)
