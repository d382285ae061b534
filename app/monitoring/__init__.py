"""How the station itself is doing: health, logs, load."""
