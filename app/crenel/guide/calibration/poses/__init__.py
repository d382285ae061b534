"""The poses of a calibration: detection in each capture, and which pose helps most next."""
