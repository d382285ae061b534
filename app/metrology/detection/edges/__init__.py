"""All edges of the block measured to a fraction of a pixel. Entry point: ``measure_all``."""
