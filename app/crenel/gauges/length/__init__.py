"""The test of lengths on a ball bar or step gauge."""
