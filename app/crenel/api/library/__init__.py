"""The library of scans: its records, and the one that is opened in the 3D view."""
