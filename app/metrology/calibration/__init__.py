"""Calibration from one pose, and what every calibration reports.

Entry point: ``one_pose``. ``camera_refinement`` refines Faugeras' camera, ``observation_model``
predicts what is observed, ``uncertainty_budget`` and ``findings`` report.
"""
