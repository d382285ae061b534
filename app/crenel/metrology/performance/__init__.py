"""Performance tests of arms and scanners, as a datasheet states them.

The quantities of ISO 10360-8 and -12 (size, form, dispersion, location, length) and of
ASME B89.4.22, with their test value uncertainty. Pure.
"""
