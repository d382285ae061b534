"""A process that publishes as a station does, and nothing else; takes a port and an id."""

import asyncio
import sys
from datetime import UTC, datetime

from app.supervision.broker import Broker
from app.supervision.broker_settings import BrokerSettings
from app.supervision.messages import (
    ActivityReport,
    DeviceReport,
    StationEvent,
    StationReport,
    new_instance,
)
from app.supervision.remote_stations import Fleet

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
SENSORS = tuple(
    DEVICE.model_copy(
        update={"name": "camera", "sensor": name, "rate_hz": 30.0, "lost": lost, "stamps": "device"}
    )
    for name, lost in (("left", 0), ("right", 12))
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
    return StationEvent(
        station=station,
        instance=instance,
        number=number,
        at=datetime.now(UTC).isoformat(),
        kind="scan-saved",
        quality="good",
        text=f"scan {number}",
    )


async def publish(port: int, station: str) -> None:
    instance = new_instance()
    settings = BrokerSettings(host="127.0.0.1", port=port)
    broker = Broker(settings, station, station.title(), instance, Fleet())
    running = asyncio.create_task(broker.run())
    number = 0
    while not running.done():
        number += 1
        broker.report(make_report(station, instance, devices=(DEVICE, *SENSORS)))
        broker.event(make_event(station, instance, number))
        if broker.state.connected and number % 5 == 1:
            print("connected", flush=True)
        await asyncio.sleep(0.5)
    running.result()


if __name__ == "__main__":
    asyncio.run(publish(int(sys.argv[1]), sys.argv[2]))
