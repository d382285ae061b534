"""The scans of a plate in a performance test."""
