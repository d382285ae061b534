"""Errors of probed and scanned gauges relative to their certificates.

Entry points: ``probed_gauge`` fits a gauge to contact points, ``scanned_gauge`` to a cloud;
``errors`` compares fits with nominals and states repeatability, and ``tip_check.check_tip`` judges
the tip on a sphere.
"""
