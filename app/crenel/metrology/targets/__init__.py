"""Calibration targets: the crenellated block and the chessboard.

Entry points: ``crenellated_block.corners``, ``edges`` and ``probing_face`` give the geometry of
a block, ``chessboard.corner_points`` that of a board; ``target`` covers both.
"""
