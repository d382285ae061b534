"""The test on one sphere."""
