"""The verification of the calibration in use on a gauge: touched, scanned, judged."""
