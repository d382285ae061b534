"""What is reported of each pose and its stripe."""
