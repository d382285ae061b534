"""Crenel: an articulated arm and a laser stripe sensor, calibrated in one step.

The names of ``crenel.public`` are the public interface, described in ``docs/python.md``: ``from
crenel import extract_stripe``. All other modules may change. They are imported when the first of
the names is used, so that ``import crenel`` itself costs nothing.
"""

import os
from importlib import import_module
from typing import TYPE_CHECKING

# The matrices here are small: BLAS on many threads only gets in the way of the
# station's own. The limit has to be set before numpy is imported.
for _library in ("OPENBLAS", "MKL", "OMP"):
    os.environ.setdefault(f"{_library}_NUM_THREADS", "1")

# Before OpenCV is imported, too: larger pictures are refused by it, whatever their kind.
os.environ.setdefault("OPENCV_IO_MAX_IMAGE_PIXELS", "100000000")

if TYPE_CHECKING:
    from crenel.public import *  # noqa: F403
    from crenel.public import __all__ as __all__
else:

    def __getattr__(name):
        """A public name; ``AttributeError`` of others, and of modules that are not imported."""
        if name.startswith("_") and name != "__all__":
            raise AttributeError(name)
        public = import_module(f"{__name__}.public")
        if name == "__all__" or name in public.__all__:
            return getattr(public, name)
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")

    def __dir__():
        return sorted({*globals(), *__getattr__("__all__")})
