"""The quick verification: a gauge is touched and scanned, and both are compared."""
