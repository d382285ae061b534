"""Point clouds with an uncertainty per point: PLY, PCD, XYZ, E57, LAS, LAZ and COPC.

``files`` reads and writes any of them; ``ply`` appends while a scan runs.
"""
