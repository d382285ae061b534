"""The 3D view's page and socket, passed through by the station."""
