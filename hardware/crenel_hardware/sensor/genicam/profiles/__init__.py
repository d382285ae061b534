"""Profiles: the rows of the laser line, which a camera finds by itself."""
