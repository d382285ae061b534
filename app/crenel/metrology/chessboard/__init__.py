"""A flat chessboard as calibration target: its detection in an image.

Entry point: ``detect_board``. ``saddle_points`` finds candidates, ``lattice`` joins them to grids,
``opencv_finders`` helps where that fails, ``corner_fit`` measures each corner, ``window`` finds
the board's own among them, and ``failure_evidence`` says why not. ``charuco_board`` has what is
different where markers number the corners.
"""
