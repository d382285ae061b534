"""Results of performance tests for other programs: CSV, XLSX, QIF, calibration certificates."""
