"""Benchmarks of stripe extraction, beside OpenCV and numpy."""
