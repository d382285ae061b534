"""Calibration from one pose, and what every calibration reports.

Entry point: ``one_pose.calibrate_one_pose``. ``laser_plane_fit`` sorts the stripe by levels and
fits the laser plane, ``camera_refinement`` refines Faugeras' camera, ``observation_model``
predicts the observations, ``uncertainty_budget`` and ``findings`` report. ``drift.measure_drift``
compares two calibrations.
"""
