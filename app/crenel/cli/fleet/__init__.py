"""``crenel catalogue``: ``catalogue`` collects and finds records, ``questions`` answers."""
