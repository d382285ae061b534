"""The stripe sensor: camera, laser plane, and points from pixels (Eq. 9).

Entry points: ``camera.project`` and ``camera.rays`` convert points to pixels and back,
``triangulation`` converts stripe pixels to points, and ``faugeras.solve_faugeras`` computes a first
camera from known points.
"""
