"""Performance tests: from the folder of a test to its figures."""
