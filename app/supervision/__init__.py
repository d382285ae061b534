"""Supervision of stations by others: MQTT, notifications, and the stations that are watched."""
