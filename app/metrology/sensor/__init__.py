"""The stripe sensor: camera, light plane, and points from pixels (Eq. 9).

Entry points: ``camera.project`` and ``camera.rays`` go from points to pixels and back,
``triangulation`` from stripe pixels to points, ``faugeras.solve_faugeras`` from known points to
a first camera.
"""
