"""Drivers of measuring arms."""
