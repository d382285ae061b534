"""A process that publishes as a station does, and nothing else; takes a port and an id."""

import asyncio
import sys

from crenel.supervision.broker import Broker
from crenel.supervision.broker_settings import BrokerSettings
from crenel.supervision.messages import new_instance
from crenel.supervision.remote_stations import Fleet
from tests.bench.faults.broker.usual_messages import DEVICE, make_event, make_report

CAMERA = DEVICE.model_copy(update={"name": "camera", "rate_hz": 30.0, "stamps": "device"})
SENSORS = tuple(
    CAMERA.model_copy(update={"sensor": name, "lost": lost})
    for name, lost in (("left", 0), ("right", 12))
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
