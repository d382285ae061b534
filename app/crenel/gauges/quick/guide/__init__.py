"""The guided session of the quick verification."""
