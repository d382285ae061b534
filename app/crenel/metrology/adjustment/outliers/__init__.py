"""Observations that contradict the others, and hypotheses of systematic faults."""
