"""The test of form on a plate."""
