"""Watching stations from afar: what each tells of itself, over MQTT and to whom it may concern."""
