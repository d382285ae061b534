"""The constant delay between arm and camera.

Entry point: ``delay.estimate_delay``, from a ``plane_pass.PlanePass``; ``delay_fit`` is its
maximum-likelihood fit.
"""
