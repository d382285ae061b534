"""The station as a process, from its start to its end.

1. ``startup``: the page is available at once while everything heavy is loaded.
2. ``listener``, ``connections``, ``middleware``: the socket, and the limits of requests.
3. ``starting_page``: answers requests until the station is ready.
4. ``composition``: creates all parts of the station; ``demo`` those of the simulated one.
5. ``application``: the FastAPI application around them.
"""
