"""A flat chessboard as the target of a calibration: its certificate, and finding it.

Entry point: ``detect_board``. ``saddle_points`` finds candidates, ``grid`` joins them to a
lattice, ``corner_fit`` measures each corner, and ``failure_evidence`` says why not.
"""
