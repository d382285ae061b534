"""Routes of the guided sessions: calibration, verification, performance, checks of the arm."""
