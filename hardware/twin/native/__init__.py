"""The simulator's loops in C: rendering, and the simulated arm's kinematics."""

from app.native.build import LIBRARIES
from app.native.library import Library

SIMULATOR = Library(LIBRARIES[1])
