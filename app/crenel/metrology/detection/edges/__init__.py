"""Sub-pixel measurement of all edges of the block. Entry point: ``measure_all``."""
