"""The camera's features: their names by the Standard Features Naming Convention, and their limits.

Source:
    EMVA, GenICam Standard Features Naming Convention (SFNC) 2.7.
"""

from crenel_hardware.simulator.devices.gige_camera.feature import Feature
from crenel_hardware.simulator.devices.gige_camera.pixels import CODES
from crenel_hardware.simulator.devices.gige_camera.profile_features import profile_features

BASE = 0x10000
"""Address of the first feature; those below belong to the standard."""
_SLOT = 8
LINES = {"Line1": 0, "Line2": 1}
OUTPUTS = {"UserOutput1": 0, "UserOutput2": 1}
EXPOSURE_ACTIVE = 0
"""A value of ``LineSource``; user outputs follow."""
EXPOSURE_RANGE_US = (50.0, 20_000.0)
MOST_HZ = 200.0


def camera_features(
    width_px: int, height_px: int, rate_hz: float, fewest_profiles: int | None = None
) -> dict[int, Feature]:
    """All features of a camera by address, with the whole sensor as the region.

    A feature with a selector takes ``_SLOT`` bytes for each of its entries.

    Args:
        fewest_profiles: the least height of a buffer with profiles; None of a camera without them.
    """
    ordered = [
        *_picture_features(width_px, height_px),
        *_acquisition_features(rate_hz),
        *_line_features(),
    ]
    if fewest_profiles is not None:
        ordered = profile_features(ordered, fewest_profiles)
    placed, address = {}, BASE
    for feature in ordered:
        placed[address] = feature
        address += _SLOT * len(feature.initial)
    return placed


def _size(name: str, value: int, limit: str, least: int = 0) -> Feature:
    return Feature(
        name,
        "integer",
        "ImageFormatControl",
        value,
        least=least,
        most=1 << 16,
        step=4,
        limit=limit,
        locked=True,
        unit="px",
    )


def _picture_features(width_px: int, height_px: int) -> list[Feature]:
    group = "ImageFormatControl"
    most = 1 << 31
    return [
        Feature("SensorWidth", "integer", group, width_px, most=most, writable=False),
        Feature("SensorHeight", "integer", group, height_px, most=most, writable=False),
        Feature("WidthMax", "integer", group, width_px, most=most, writable=False),
        Feature("HeightMax", "integer", group, height_px, most=most, writable=False),
        _size("Width", width_px, "WidthMax - OffsetX", 16),
        _size("Height", height_px, "HeightMax - OffsetY", 4),
        _size("OffsetX", 0, "WidthMax - Width"),
        _size("OffsetY", 0, "HeightMax - Height"),
        Feature("PixelFormat", "enumeration", group, CODES["Mono8"], entries=CODES, locked=True),
        Feature("PayloadSize", "integer", "TransportLayerControl", 0, most=most, writable=False),
        Feature("TLParamsLocked", "integer", "TransportLayerControl"),
    ]


def _acquisition_features(rate_hz: float) -> list[Feature]:
    group = "AcquisitionControl"
    modes = {"Continuous": 0, "SingleFrame": 1, "MultiFrame": 2}
    shortest, longest = EXPOSURE_RANGE_US
    return [
        Feature("AcquisitionMode", "enumeration", group, entries=modes, locked=True),
        Feature("AcquisitionFrameCount", "integer", group, 1, least=1, most=1000),
        Feature("AcquisitionStart", "command", group),
        Feature("AcquisitionStop", "command", group),
        Feature("AcquisitionFrameRateEnable", "boolean", group, 1),
        Feature("AcquisitionFrameRate", "float", group, rate_hz, 0.1, MOST_HZ, unit="Hz"),
        Feature("ExposureMode", "enumeration", group, entries={"Timed": 0}),
        Feature("ExposureTime", "float", group, 5000.0, shortest, longest, unit="us"),
        Feature("TriggerSelector", "enumeration", group, entries={"FrameStart": 0}),
        Feature("TriggerMode", "enumeration", group, entries={"Off": 0, "On": 1}, locked=True),
        Feature(
            "TriggerSource", "enumeration", group, entries={"Line1": 0, "Software": 1}, locked=True
        ),
        Feature(
            "TriggerActivation",
            "enumeration",
            group,
            entries={"RisingEdge": 0, "FallingEdge": 1},
            locked=True,
        ),
        Feature("TriggerSoftware", "command", group),
    ]


def _line_features() -> list[Feature]:
    group = "DigitalIOControl"
    line = "LineSelector"
    sources = {"ExposureActive": EXPOSURE_ACTIVE} | {
        name: number + 1 for name, number in OUTPUTS.items()
    }
    return [
        Feature("LineSelector", "enumeration", group, entries=LINES),
        Feature(
            "LineMode",
            "enumeration",
            group,
            entries={"Input": 0, "Output": 1},
            values=(0, 1),
            selector=line,
        ),
        Feature(
            "LineSource",
            "enumeration",
            group,
            entries=sources,
            values=(0, EXPOSURE_ACTIVE),
            selector=line,
        ),
        Feature("LineStatus", "boolean", group, writable=False, values=(0, 0), selector=line),
        Feature("UserOutputSelector", "enumeration", group, entries=OUTPUTS),
        Feature("UserOutputValue", "boolean", group, values=(0, 0), selector="UserOutputSelector"),
    ]
