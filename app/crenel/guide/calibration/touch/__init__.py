"""The contact points of a calibration: taken, undone, and judged against the target."""
