"""The simulator's loops in C: rendering, and the simulated arm's kinematics."""

from app.native.library import NativeLibrary
from app.native.sources import LIBRARIES

SIMULATOR = NativeLibrary(LIBRARIES[1])
