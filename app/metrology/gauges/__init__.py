"""Errors of probed and scanned gauges against their certificates (ISO 14253-1)."""
