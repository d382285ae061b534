"""What the drivers of robot controllers share: a link, the arm in front of it, rotations."""
