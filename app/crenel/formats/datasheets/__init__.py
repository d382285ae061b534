"""Datasheets and certificates: arm, sensor, calibration target and gauge."""
