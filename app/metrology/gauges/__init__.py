"""Errors of probed and scanned gauges relative to their certificates (ISO 14253-1).

Entry points: ``probed_gauge`` fits a gauge to contact points, ``scanned_gauge`` to a cloud;
``errors`` compares fits with nominals, states repeatability and applies the decision rule, and
``tip_check.check_tip`` judges the tip on a sphere.
"""
