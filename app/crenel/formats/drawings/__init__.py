"""Drawings of parts, and their solids, for those who make them.

``drawing`` is what a drawing consists of; ``dxf``, ``stl`` and ``step`` write files for other
programs.
"""
