"""The ``genicam`` driver: a camera with GigE Vision or USB3 Vision.

In station.toml::

    [sensor]
    driver = "genicam"
    address = "192.168.1.30"     # of a GigE Vision camera; or:
    serial_number = "22812345"   # found by a search; without both, the first camera found
    pixel_format = "Mono12p"     # optional, a name of PFNC; else as the camera is set
    region = [0, 256, 1920, 512] # optional: x, y, width, height in px; else the whole sensor
    exposure_us = 2000.0         # optional; else as the camera is set
    exposure_range_us = [50.0, 20000.0]  # optional: limits what the operator may set
    gain_db = 0.0                # optional; else as the camera is set
    rate_hz = 100.0              # optional; else as the camera is set
    packet_size = 8192           # optional, of GigE Vision: in bytes, with jumbo frames
    trigger = "Line1"            # optional: a picture at each edge of this input
    trigger_edge = "rising"      # optional: or "falling"
    laser_line = "Line2"         # optional: the output that switches the laser
    stamp_at = "exposure-start"  # optional: what the camera's time stamp belongs to, see below
    latency_us = 0.0             # optional: taken off each stamp
    chunks = ["ExposureTime"]    # optional: data that the camera appends to each picture
    laser_colour = "red"         # required of a colour camera: red, green or blue
    bayer = "RGGB"               # optional: raw pictures in a format that does not say so
    line_rows = "region"         # optional, of lines: what rows count from, or "sensor"
    line_offset_px = 0.0         # optional: added to the rows of lines
    line_sigma_px = 0.06         # optional: standard deviation of a row; else it is measured
    line_rate_hz = 500.0         # optional: lines per second; else as the camera is set

The whole sensor, a fixed exposure and gain, and no trigger are set whenever the options do not
say otherwise. Of a raw colour format (BayerRG8 and its like) the pixels of the laser's colour
alone are the picture, without interpolation: half as wide and high as the sensor.

Losses: the camera numbers its pictures, so those that the network loses are counted. A picture of
which a packet is missing, after it was requested again, counts as lost.

Stamps: the camera's own time, converted to the host's. The manual of the camera says what it
stamps: ``"exposure-start"``, ``"mid-exposure"``, ``"exposure-end"`` or ``"frame-end"``. The clock
of a GigE Vision camera is read every second if it can be latched, so that it does not matter how
late pictures arrive. Else the arrivals relate the clocks, and the minimum delay from
the stamped event to the first packet cannot be seen from here; set it as ``latency_us``. A camera
that does not stamp its pictures gets the times of their arrival.

Lines: a camera that finds the laser line itself sends it if asked (``set_delivery``), in the output
mode ``UncalibratedC`` of SFNC alone, one profile in each buffer
(``crenel_hardware.sensor.genicam.profiles``). A line refers to the picture of the region. The
camera is stopped to be changed; the count goes on.

Trigger: the camera is silent by right, and is asked whether it is there. ``Frame.pulse`` counts its
exposures from 1.
"""

import threading
from collections.abc import Mapping

from crenel.messages.message import Text, message
from crenel_hardware.options import read_options
from crenel_hardware.sensor.genicam.aravis_source import GenicamSource
from crenel_hardware.sensor.genicam.settings import GenicamOptions
from crenel_hardware.sensor.grabbing import GrabbingSensor
from crenel_hardware.sensor.grey import require_colour

FIRST_WITHIN_S = 5.0
"""A camera that sends no picture within this time of its start is refused."""


def from_options(options: Mapping[str, object]) -> GrabbingSensor:
    """The driver for one ``[sensor]`` table of station.toml; raises ``DeviceError``."""
    read = read_options(GenicamOptions, options, "sensor")
    require_colour(read.bayer, read.laser_colour)
    title = camera_title(read)

    def connect(stop: threading.Event) -> GenicamSource:
        return GenicamSource(title, read, stop)

    return GrabbingSensor(title, connect, FIRST_WITHIN_S)


def camera_title(options: GenicamOptions) -> Text:
    """The camera in words: its address, its serial number, or the first one."""
    named = options.address or options.serial_number
    return message("first-genicam-camera") if named is None else message("camera", source=named)
