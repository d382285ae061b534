"""The page and socket of the 3D view, relayed by the station."""
