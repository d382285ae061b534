"""What is seen in single pictures: stripes and calibration targets, as tables and drawn.

Entry points: ``extract_stripes``, ``detect_targets``, ``draw_pictures``.
"""
