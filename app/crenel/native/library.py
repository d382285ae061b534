"""Finds, checks and loads a compiled library, and selects its processor variant.

``CRENEL`` is the library of the product.
"""

import ctypes
import os
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from functools import cached_property

from crenel.native.sources import (
    LIBRARIES,
    BuildTarget,
    LibraryError,
    LibrarySource,
    source_hash,
    variant_flags,
)

VARIANT_SETTING = "CRENEL_VARIANT"
"""Environment variable that names a variant, such as v1; by default, the best one is used."""
REBUILD = "python -m crenel.native.build"


class NativeLibrary:
    """A compiled library, loaded when one of its functions is first requested."""

    def __init__(self, source: LibrarySource) -> None:
        self._source = source
        self._variant = ""

    def load(self) -> None:
        """Loads the library, if it is not loaded yet.

        Raises:
            LibraryError: it is missing, older than its sources, or not for this processor.
        """
        _ = self.variant

    @property
    def variant(self) -> str:
        """The variant whose functions are called: v1, v3 or v4."""
        if not self._variant:
            self._variant = self._choose_variant()
        return self._variant

    @property
    def variants(self) -> tuple[str, ...]:
        """The variants that this processor supports, the least demanding first."""
        best = f"v{self._loaded.crenel_best_variant()}"
        known = tuple(variant_flags(BuildTarget.here()))
        return known[: known.index(best) + 1]

    @contextmanager
    def using(self, variant: str) -> Iterator[None]:
        """Uses another variant temporarily, in all threads: for tests and benchmarks."""
        before = self.variant
        self._variant = self._check_variant(variant)
        try:
            yield
        finally:
            self._variant = before

    def symbol(self, name: str, variant: str) -> "ctypes._NamedFuncPointer":
        """A function of a variant, with undeclared arguments.

        Raises:
            LibraryError: the library cannot be loaded.
            AttributeError: it has no such function.
        """
        # a separate function object per declaration, because argument types are its attributes
        return self._loaded[f"crenel_{variant}_{name}"]

    @cached_property
    def _loaded(self) -> ctypes.CDLL:
        path = self._source.library_path()
        if not path.is_file():
            raise LibraryError(f"{path} is not built. Build it: {REBUILD}")
        try:
            library = ctypes.CDLL(str(path))
        except OSError as error:
            raise LibraryError(f"{path} cannot be loaded: {error}. Build it: {REBUILD}") from error
        library.crenel_sources.restype = ctypes.c_char_p
        library.crenel_best_variant.restype = ctypes.c_int
        # an installed package has no sources, which therefore cannot have changed
        if self._source.files and library.crenel_sources().decode() != source_hash(self._source):
            raise LibraryError(f"{path} is older than its C sources. Build it: {REBUILD}")
        return library

    def _choose_variant(self) -> str:
        named = os.environ.get(VARIANT_SETTING)
        return self._check_variant(named) if named else self.variants[-1]

    def _check_variant(self, variant: str) -> str:
        if variant not in self.variants:
            able = ", ".join(self.variants)
            raise LibraryError(
                f"The variant {variant} does not run on this processor; {VARIANT_SETTING} "
                f"may name one of: {able}"
            )
        return variant


if sys.byteorder != "little":  # pragma: no cover - the formats read by the loops are, too
    raise LibraryError("Crenel needs a little-endian processor")


CRENEL = NativeLibrary(LIBRARIES[0])
