"""The joint adjustment with the crenellated block. Entry point: ``calibrate``."""
