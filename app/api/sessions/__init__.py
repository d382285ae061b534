"""Routes of the guided sessions: calibration, verification, performance tests, checks of the arm."""
