"""Gauges in clouds, whichever scanner they come from."""
