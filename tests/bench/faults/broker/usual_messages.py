"""Messages as a usual station publishes them; for tests, too."""

from datetime import UTC, datetime

from crenel.supervision.messages import ActivityReport, DeviceReport, StationEvent, StationReport

DEVICE = DeviceReport(
    name="arm",
    state="connected",
    text="an arm",
    age_s=0.01,
    rate_hz=1000.0,
    received=5,
    lost=0,
    corrupt=0,
)
IDLE = ActivityReport(
    kind="idle",
    title="Nothing is running",
    step=0,
    steps=0,
    progress="",
    points=0,
    rate_points_s=0.0,
    lost_frames=0,
)


def make_report(station: str, instance: str, **changed: object) -> StationReport:
    """Of a station where nothing is running, except for the changed fields."""
    return StationReport(
        station=station,
        instance=instance,
        name=station.title(),
        version="1",
        simulated=True,
        address="",
        at=datetime.now(UTC).isoformat(),
        up_s=1.0,
        devices=(DEVICE,),
        laser_on=False,
        activity=IDLE,
        calibration=None,
        verification=None,
        alarms=(),
        temperature_c=21.4,
        disk_free_gb=100.0,
        control=None,
    ).model_copy(update=changed)


def make_event(station: str, instance: str, number: int) -> StationEvent:
    """That a scan of this number was saved."""
    return StationEvent(
        station=station,
        instance=instance,
        number=number,
        at=datetime.now(UTC).isoformat(),
        kind="scan-saved",
        quality="good",
        text=f"scan {number}",
    )
