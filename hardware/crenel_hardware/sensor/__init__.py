"""Drivers of the laser stripe sensor's camera."""
