"""What calibrations, verifications and checks leave behind."""
