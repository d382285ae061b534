"""A real broker on which strangers publish, and a station that listens to it."""
