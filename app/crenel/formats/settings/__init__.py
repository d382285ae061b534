"""Settings: of scanning, and what the tables of ``station.toml`` are made of."""
