"""``station.toml``: ``station_toml`` reads and checks it, ``settings`` are what it means."""
