"""What the operator is walked through: an append-only journal and flows folded from it."""
