"""The live image with what is detected in it, and what would make a better capture."""
