"""Clouds on demand, ordered in the *Fleet* page.

``service`` knows the places of every station, ``queue`` makes one cloud after the other in a
``process`` of its own, ``orders_file`` keeps what waits over restarts, and ``kept_clouds`` what is
made, up to a limit; ``routes`` answers browsers.
"""
