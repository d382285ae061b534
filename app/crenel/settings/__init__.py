"""``station.toml``: ``station_toml`` reads it, ``settings`` are what it says and check it."""
