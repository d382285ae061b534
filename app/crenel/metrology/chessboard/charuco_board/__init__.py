"""ChArUco boards: their markers read, their corners measured, and why they were not found."""
