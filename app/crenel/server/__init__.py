"""The station as a process, from its start to its end.

1. ``startup``: the page is available at once while everything heavy is loaded.
2. ``listener``, ``connections``, ``middleware``: the socket, and the limits of requests.
3. ``starting_page``: answers requests until the station is ready.
4. ``station_parts``: what makes one station differ from another, as ``demo`` the simulated one.
   ``composition`` creates all parts from it: ``live_station`` (devices, scans, views) and
   ``guides`` among them.
5. ``application``: the FastAPI application around them.
"""
