"""Parts: features, dimensions and alignments from scans and touches, with their uncertainty.

``cad`` has files of nominal shapes and the closest point of a mesh, ``deviation`` how far a scan
is from one.
"""
