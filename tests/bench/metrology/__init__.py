"""Benchmarks of calibration and detection on simulated data with known truth."""
