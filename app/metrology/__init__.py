"""The mathematics of the station: arrays in, arrays out.

Nothing here reads a file, a clock, a device or the web. Lengths are millimetres,
angles radians, pixels ``(u, v)`` with the centre of the top-left pixel at (0, 0).
``T_ab`` maps coordinates in frame b to frame a: ``x_a = T_ab @ x_b``.
"""
