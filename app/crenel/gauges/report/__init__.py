"""The report of a gauge test."""
