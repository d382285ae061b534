"""Clouds of gauges compared with their nominals: ``crenel verify``."""
