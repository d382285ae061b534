"""Clouds on demand, ordered in the *Fleet* page.

``service`` knows the places of every station, ``queue`` makes one cloud after the other in a
``process`` of its own, and ``kept_clouds`` keeps them up to a limit; ``routes`` answers browsers.
"""
