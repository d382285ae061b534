"""Trigger pulses: the arm starts the exposures of the cameras, and both count them."""
