"""The station's database: journals, calibrations, scans, accounts and audit log."""
