"""Benchmarks of the whole station: start, live scanning, viewers."""
