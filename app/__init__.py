"""Crenel: an articulated arm and a laser stripe sensor, calibrated in one step."""
