"""Drawings of parts, and their solids, for those who make them.

``drawing`` is what a drawing consists of; ``dxf`` and ``stl`` write files for other programs.
"""
