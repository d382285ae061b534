"""Checks of what was measured, before and after the fit: points, places, artefacts, coordinates."""
