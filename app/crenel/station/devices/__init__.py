"""The arm and the sensor of the station, each read by its own thread.

``rig`` has both. ``device_thread`` opens, reads and reopens a device; ``arm_device`` and
``sensor_device`` store their data in ``reading_buffer`` and ``frame_hub``.
"""
