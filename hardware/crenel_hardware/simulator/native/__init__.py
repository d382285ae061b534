"""The simulator's loops in C: rendering, and the simulated arm's kinematics."""

from crenel.native.library import NativeLibrary
from crenel.native.sources import LIBRARIES

SIMULATOR = NativeLibrary(LIBRARIES[1])
