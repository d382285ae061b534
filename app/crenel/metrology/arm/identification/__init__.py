"""Identification of the arm's geometry from seats, spheres, ball bars and coordinates.

Entry point: ``identify``. ``checks`` refuse what cannot be used, ``parameter_selection``
chooses what can be estimated, ``robust_solve`` solves, ``cross_validation`` and
``volumetric_error`` say how good the result is. ``articulation.check_articulation`` is the daily
check.
"""
