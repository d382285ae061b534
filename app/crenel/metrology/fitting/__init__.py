"""Planes, spheres and cylinders through points, with their uncertainty.

Entry points: ``fit_plane``, ``fit_sphere`` and ``fit_cylinder`` fit one shape to points;
``shape.measure_shape`` adds the covariance of its parameters from the scatter between frames;
``deviation_map`` averages the deviations over a flat grid.
"""
