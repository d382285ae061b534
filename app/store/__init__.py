"""The station's database: journals and calibrations."""
