"""The live image with its detections, and advice for a better capture."""
