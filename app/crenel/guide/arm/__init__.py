"""Guided checks of the arm: its tip on a sphere, articulation, and identification."""
