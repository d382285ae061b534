"""Contact points on the target, and the target's frame in the arm."""
