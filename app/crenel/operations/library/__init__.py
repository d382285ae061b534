"""Scans as records: parts, files, pictures, merged clouds, and what is opened in the 3D view."""
