"""A flat chessboard as the object of a calibration: its certificate, and finding it."""
