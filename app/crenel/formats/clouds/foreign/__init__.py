"""Clouds that are read but not written: meshes, PTX, and arrays of numpy."""
