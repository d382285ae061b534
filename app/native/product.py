"""The product's own library."""

from app.native.library import Library
from app.native.sources import LIBRARIES

CRENEL = Library(LIBRARIES[0])
