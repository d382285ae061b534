"""The station as a program: from its start to its end.

1. ``startup``: the page answers at once, everything heavy is loaded behind it.
2. ``listener``, ``connections``, ``middleware``: the socket, and the bounds of what may be sent.
3. ``starting_page``: what answers until the station is ready.
4. ``composition``: makes all parts of the station; ``demo`` those of the simulated one.
5. ``application``: the FastAPI application around them.
"""
