"""The joint adjustment: one most likely calibration from all poses, contacts and papers at once."""
