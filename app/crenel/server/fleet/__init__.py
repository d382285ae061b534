"""``crenel fleet``: a server with one page for all stations: catalogue, drift, archive, MQTT."""
