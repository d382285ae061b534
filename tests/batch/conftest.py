"""Fixtures of all tests of this folder."""

from tests.batch.standing_dask import standing_dask

__all__ = ["standing_dask"]
