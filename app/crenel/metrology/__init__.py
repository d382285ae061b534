"""The mathematics of the station: arrays in, arrays out.

Nothing here reads a file, a clock, a device or the web. Lengths are millimetres,
angles radians, pixels ``(u, v)`` with the centre of the top-left pixel at (0, 0).
``T_ab`` maps coordinates in frame b to frame a: ``x_a = T_ab @ x_b``. Shapes are ``(N, 3)``:
N points of three coordinates; n is the number of joints, (H, W) an image of height H.

Uncertainties are standard uncertainties, k = 1, unless stated otherwise. "The article", with
its equations (Eq.) and figures, is *A crenellated-object-based intrinsic and extrinsic
calibration method for laser stripe sensors integration in articulated coordinate measurement
arms*. A job that the data do not allow raises ``crenel.errors.OperationError``, whose ``code`` the
docstrings name.
"""
