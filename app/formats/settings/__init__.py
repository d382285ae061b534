"""Settings of scanning: masks, and how stripes are extracted."""
