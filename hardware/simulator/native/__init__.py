"""The simulator's loops in C: rendering, and the simulated arm's kinematics."""

from app.native.library import Library
from app.native.sources import LIBRARIES

SIMULATOR = Library(LIBRARIES[1])
