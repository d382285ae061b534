"""The view of each step of the guided calibration."""
