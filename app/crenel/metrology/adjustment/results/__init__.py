"""Results for each pose and its stripe."""
