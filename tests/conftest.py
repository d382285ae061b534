"""Fixtures that every room's tests share."""

from pathlib import Path

import pytest
from hypothesis import settings

import app  # noqa: F401  # sets the numerical libraries' threads before numpy is loaded

FIRST = Path(__file__).parent / "api/test_flow.py"
"""Counts what the station compiles while it works; other tests' loops would hide some."""
SHARED = Path(__file__).resolve().parents[2] / "shared"

settings.register_profile("long", max_examples=5_000, deadline=None)


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    items.sort(key=lambda item: item.path != FIRST)


@pytest.fixture(scope="session")
def samples() -> Path:
    """The folder of sample sessions with their truth, kept beside the checkout."""
    folder = SHARED / "samples"
    if not folder.is_dir():
        pytest.skip("the sample sessions are not beside this checkout")
    return folder


@pytest.fixture(scope="session")
def real() -> Path:
    """The folder of real recordings by others, kept beside the checkout."""
    folder = SHARED / "real"
    if not folder.is_dir():
        pytest.skip("the real recordings are not beside this checkout")
    return folder
