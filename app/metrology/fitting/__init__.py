"""Planes, spheres and cylinders through points, with their uncertainty."""
