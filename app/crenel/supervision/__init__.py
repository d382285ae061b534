"""Supervision: MQTT, notifications, and other stations."""
