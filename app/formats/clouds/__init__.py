"""Point clouds with an uncertainty per point: PLY, PCD, XYZ, E57, LAS and LAZ.

``files`` reads and writes any of them; ``ply`` appends while a scan runs.
"""
