"""Robots of Universal Robots, read by their Real-Time Data Exchange (RTDE)."""
