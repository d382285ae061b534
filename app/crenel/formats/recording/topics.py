"""The topics of a recording: those of the arm, and those of each sensor.

A station with one sensor records it as ``/sensor/stripe``; one with several names them, as in
``/sensor/left/stripe``.
"""

import re
from collections.abc import Mapping

JOINTS_TOPIC, POSE_TOPIC = "/arm/joints", "/arm/pose"
IMAGE_TOPIC, STRIPE_TOPIC = "/sensor/image", "/sensor/stripe"
SENSOR_NAME = re.compile(r"[A-Za-z][A-Za-z0-9_]{0,39}")
"""Names of the sensors of one station."""
_NAMED = re.compile(rf"/sensor/({SENSOR_NAME.pattern})/(image|stripe)")


def sensor_topic(topic: str, sensor: str) -> str:
    """The topic of a named sensor, from that of the only one.

    >>> sensor_topic(STRIPE_TOPIC, "left"), sensor_topic(STRIPE_TOPIC, "")
    ('/sensor/left/stripe', '/sensor/stripe')
    """
    return topic.replace("/sensor/", f"/sensor/{sensor}/", 1) if sensor else topic


def split_topic(topic: str) -> tuple[str, str]:
    """The topic as of the only sensor, and the sensor's name; empty of the only one and the arm.

    >>> split_topic("/sensor/left/stripe"), split_topic("/arm/joints")
    (('/sensor/stripe', 'left'), ('/arm/joints', ''))
    """
    named = _NAMED.fullmatch(topic)
    return (topic, "") if named is None else (f"/sensor/{named[2]}", named[1])


def sensor_key(key: str, sensor: str) -> str:
    """A property of a sensor in the metadata of the station.

    >>> sensor_key("sensor_serial", "left"), sensor_key("sensor_serial", "")
    ('sensor_serial/left', 'sensor_serial')
    """
    return f"{key}/{sensor}" if sensor else key


def sensor_values(station: Mapping[str, str], key: str) -> dict[str, str]:
    """A property of each sensor in the metadata of the station, by the sensor's name.

    >>> sensor_values({"scan_calibration": "c1", "scan_calibration/left": "c2"}, "scan_calibration")
    {'': 'c1', 'left': 'c2'}
    """
    found = {}
    for name, value in station.items():
        plain, slash, sensor = name.partition("/")
        if plain == key and bool(slash) == bool(sensor):
            found[sensor] = value
    return found
