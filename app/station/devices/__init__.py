"""The arm and the sensor of the station, each read by a thread of its own.

``rig`` has both. ``device_thread`` opens, reads and reopens a device; ``arm_device`` and
``sensor_device`` keep what was read in ``joint_buffer`` and ``frame_hub``.
"""
