"""The joint adjustment with a chessboard, bent or flat. Entry point: ``calibrate``."""
