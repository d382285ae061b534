"""The constant delay between arm and camera."""
