"""Calibration targets: the crenellated block and the chessboard."""
