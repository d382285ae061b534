"""The payloads that stations publish over MQTT, and their topics.

Every payload is one JSON object. Texts are English; a field whose name is that of a text plus
``_message`` has the same text as data, for readers of other languages. ``crenel mqtt-schema``
prints the JSON schema, and docker/SUPERVISION.md describes the rest.
"""

import re
import secrets
import unicodedata
from typing import Annotated, Literal

from pydantic import BaseModel, BeforeValidator, ConfigDict, Field, TypeAdapter

from crenel.findings import Quality
from crenel.supervision.message_data import MessageData

BEAT_S = 1.0
"""A station publishes its report at least this often, changed or not."""
LONGEST_ID = 40
ID = re.compile(r"[a-z0-9-]{1,40}")
MOST_DEVICES, MOST_ALARMS = 9, 12
"""Maximum number in one report; others are omitted."""
MOST = 2**53
"""The largest count or measured value: every reader represents it exactly."""


def _keep_first(number: int) -> BeforeValidator:
    """Keeps the first items of a list, and leaves everything else unchanged."""
    return BeforeValidator(
        lambda value: value[:number] if isinstance(value, (list, tuple)) else value
    )


ShortText = Annotated[str, Field(max_length=400)]
Name = Annotated[str, Field(max_length=80)]
Count = Annotated[int, Field(ge=0, le=MOST)]
Amount = Annotated[float, Field(ge=0, le=MOST, allow_inf_nan=False)]
SignedAmount = Annotated[float, Field(ge=-MOST, le=MOST, allow_inf_nan=False)]
Moment = Annotated[str, Field(max_length=40, description="ISO 8601, UTC")]
Activity = Literal["idle", "calibrating", "verifying", "checking_arm", "scanning", "working"]


class Payload(BaseModel):
    """A later version may add fields; unknown fields are ignored."""

    model_config = ConfigDict(frozen=True, extra="ignore")


class DeviceReport(Payload):
    """One device, with the age of its data."""

    name: Literal["arm", "camera"]
    sensor: Name = Field(
        default="", description="Name of the sensor in a station with several, otherwise empty"
    )
    state: Literal["connected", "connecting", "lost", "off"]
    text: ShortText
    text_message: MessageData = None
    age_s: Amount | None = Field(description="Age of the newest data when this was written")
    rate_hz: Amount | None
    received: Count
    lost: Count
    corrupt: Count
    quality: Quality | None = Field(
        default=None, description="As the station judges the device and its losses"
    )
    lost_lately: Count | None = Field(
        default=None, description="Lost or corrupt in the last ten minutes"
    )
    received_lately: Count | None = None
    stamps: Literal["arrival", "device", "pulse"] | None = Field(
        default=None, description="Where the time stamps of its data come from"
    )


class ActivityReport(Payload):
    """What the station is doing."""

    kind: Activity
    title: ShortText
    title_message: MessageData = None
    step: Count = Field(description="Counted from 1; 0 if there are no steps")
    steps: Count
    progress: ShortText
    progress_message: MessageData = None
    points: Count = Field(description="Points of the running scan, or of the last one")
    rate_points_s: Amount
    lost_frames: Count


class CalibrationReport(Payload):
    """The calibration in use."""

    name: ShortText
    accepted_at: Moment
    age_days: Amount
    total_um: Amount = Field(description="Standard uncertainty of a scanned point, k = 1")
    quality: Quality
    due: bool
    due_in_days: SignedAmount = Field(description="Negative if overdue")


class VerificationReport(Payload):
    """The last verification against a gauge."""

    title: ShortText
    at: Moment
    quality: Quality
    text: ShortText
    text_message: MessageData = None


class Alarm(Payload):
    """A problem that needs attention, for as long as it lasts."""

    quality: Quality
    text: ShortText
    text_message: MessageData = None
    remedy: ShortText
    remedy_message: MessageData = None


class StationReport(Payload):
    """The complete state of one station at one moment."""

    format: Literal["crenel/station-report"] = "crenel/station-report"
    station: Annotated[str, Field(pattern=r"^[a-z0-9-]{1,40}$")]
    instance: Annotated[str, Field(max_length=32)] = Field(description="New at each start")
    name: Name
    version: Name
    simulated: bool
    address: Annotated[str, Field(max_length=200, pattern="^(https?://.*)?$")] = Field(
        description="Address of its pages, or empty"
    )
    at: Moment
    up_s: Amount
    devices: Annotated[
        tuple[DeviceReport, ...], _keep_first(MOST_DEVICES), Field(max_length=MOST_DEVICES)
    ]
    laser_on: bool = Field(description="Whether it is known to be on")
    laser: Literal["on", "off", "unknown"] | None = Field(
        default=None, description="None of a station of an earlier version"
    )
    activity: ActivityReport
    calibration: CalibrationReport | None
    verification: VerificationReport | None
    alarms: Annotated[tuple[Alarm, ...], _keep_first(MOST_ALARMS), Field(max_length=MOST_ALARMS)]
    temperature_c: SignedAmount | None
    disk_free_gb: Amount
    control: Name | None = Field(description="Who has control")


class Presence(Payload):
    """Retained: the station's birth, its regular end, or its last will."""

    format: Literal["crenel/station-presence"] = "crenel/station-presence"
    station: Annotated[str, Field(pattern=r"^[a-z0-9-]{1,40}$")]
    instance: Annotated[str, Field(max_length=32)]
    name: Name
    state: Literal["online", "off", "lost"] = Field(
        description="off: ended in order; lost: the broker says so in its stead"
    )


class StationEvent(Payload):
    """An event; not retained."""

    format: Literal["crenel/station-event"] = "crenel/station-event"
    station: Annotated[str, Field(pattern=r"^[a-z0-9-]{1,40}$")]
    instance: Annotated[str, Field(max_length=32)]
    number: Count = Field(description="Increases by one within an instance")
    at: Moment
    kind: Name
    quality: Quality
    text: ShortText
    text_message: MessageData = None


KINDS: dict[str, type[Payload]] = {
    "report": StationReport,
    "presence": Presence,
    "event": StationEvent,
}
"""The payload of each topic ``PREFIX/STATION/KIND``."""


def topic(prefix: str, station: str, kind: str) -> str:
    """The topic of a payload."""
    return f"{prefix}/{station}/{kind}"


def parse_topic(prefix: str, name: str) -> tuple[str, str] | None:
    """Station and kind of a topic; None for other topics."""
    if not name.startswith(f"{prefix}/"):
        return None
    station, _, kind = name[len(prefix) + 1 :].partition("/")
    return (station, kind) if kind in KINDS and ID.fullmatch(station) else None


def station_id(name: str) -> str:
    """The name of a station as part of a topic."""
    plain = unicodedata.normalize("NFKD", name).encode("ascii", "ignore").decode().lower()
    return re.sub(r"[^a-z0-9]+", "-", plain).strip("-")[:LONGEST_ID].strip("-") or "station"


def new_instance() -> str:
    """A name for this start of the station."""
    return secrets.token_hex(6)


def schema() -> dict[str, object]:
    """The JSON schema of all payloads, each under ``$defs``, by topic."""
    any_of: TypeAdapter[StationReport | Presence | StationEvent] = TypeAdapter(
        StationReport | Presence | StationEvent
    )
    return {
        "$schema": "https://json-schema.org/draft/2020-12/schema",
        "title": "What Crenel stations publish over MQTT",
        "topics": {
            f"PREFIX/STATION/{kind}": {"$ref": f"#/$defs/{model.__name__}"}
            for kind, model in KINDS.items()
        },
        **any_of.json_schema(mode="serialization"),
    }
