"""The product's own library."""

from app.native.library import NativeLibrary
from app.native.sources import LIBRARIES

CRENEL = NativeLibrary(LIBRARIES[0])
