"""Crenel: an articulated arm and a laser stripe sensor, calibrated in one step."""

import os

# The matrices here are small: BLAS on many threads only gets in the way of the
# station's own. The limit has to be set before numpy is imported.
for _library in ("OPENBLAS", "MKL", "OMP"):
    os.environ.setdefault(f"{_library}_NUM_THREADS", "1")

# Before OpenCV is imported, too: larger pictures are refused by it, whatever their kind.
os.environ.setdefault("OPENCV_IO_MAX_IMAGE_PIXELS", "100000000")
