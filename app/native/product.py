"""The product's own library."""

from app.native.build import LIBRARIES
from app.native.library import Library

CRENEL = Library(LIBRARIES[0])
