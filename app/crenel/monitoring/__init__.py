"""The state of the station itself: health, logs, load."""
