"""Options that several drivers have, with their limits and what a form shows of them."""

from typing import Annotated, Literal, TypeAlias

from pydantic import Field, PositiveFloat, PositiveInt

from crenel.messages.message import message
from crenel_hardware.options import Shown
from crenel_hardware.sensor.grey import BayerPattern, LaserColour

RATE = Shown(message("option-rate"))
LATENCY = Shown(message("option-latency"), message("option-help-latency"))
SERIAL = Shown(message("option-serial"))
ADDRESS = Shown(message("option-address"))
EXPOSURE = Shown(message("option-exposure"))

Address: TypeAlias = Annotated[str, Field(min_length=1), ADDRESS]
KnownAddress: TypeAlias = Annotated[str | None, Field(min_length=1), ADDRESS]
"""None: any."""
Port: TypeAlias = Annotated[int, Field(ge=1, le=65535), Shown(message("option-port"))]
Url: TypeAlias = Annotated[
    str, Field(min_length=1), Shown(message("option-url"), message("option-help-url"))
]
Baudrate: TypeAlias = Annotated[PositiveInt, Shown(message("option-baudrate"))]
TimeoutSeconds: TypeAlias = Annotated[float, Field(gt=0, le=60), Shown(message("option-timeout"))]
ArmLatency: TypeAlias = Annotated[float, Field(ge=0, le=100_000), LATENCY]
"""In µs."""
Report: TypeAlias = Annotated[
    Literal["flange", "joints"],
    Shown(
        message("option-report"),
        choices={
            "flange": message("option-choice-flange"),
            "joints": message("option-choice-joints"),
        },
    ),
]

CameraLatency: TypeAlias = Annotated[float, Field(ge=0, le=1_000_000), LATENCY]
"""In µs."""
Loop: TypeAlias = Annotated[bool, Shown(message("option-loop"))]
ExposureRange: TypeAlias = Annotated[
    list[PositiveFloat] | None,
    Field(min_length=2, max_length=2),
    Shown(message("option-exposure-range"), message("option-help-exposure-range")),
]
"""In µs."""
PacketSize: TypeAlias = Annotated[
    int | None,
    Field(ge=576, le=16_000),
    Shown(message("option-packet-size"), message("option-help-packet-size")),
]
ChosenLaserColour: TypeAlias = Annotated[
    LaserColour | None,
    Shown(
        message("option-laser-colour"),
        choices={
            "red": message("option-choice-red"),
            "green": message("option-choice-green"),
            "blue": message("option-choice-blue"),
        },
    ),
]
Bayer: TypeAlias = Annotated[BayerPattern | None, Shown(message("option-bayer"))]
