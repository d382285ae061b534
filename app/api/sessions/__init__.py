"""Routes of the three guided sessions."""
