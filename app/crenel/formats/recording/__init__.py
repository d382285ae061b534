"""Recordings of scans (MCAP): written while scanning, read as a stream.

``writer`` writes; ``reader`` reads record by record, ``stream`` block by block with the arm's
joints at each frame. ``wire_format`` and ``blocks`` decode whole chunks at once.
"""
