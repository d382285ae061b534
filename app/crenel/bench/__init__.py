"""Benchmarks that ship with the product: what it does on simulated data, for anyone to run."""
