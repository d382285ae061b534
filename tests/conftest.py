"""Fixtures that all tests share."""

import gc
from collections.abc import Generator, Iterator
from itertools import groupby
from pathlib import Path

import pytest
from hypothesis import settings

import app  # noqa: F401  # sets the numerical libraries' threads before numpy is loaded
from app.native.library import CRENEL

SHARED = Path(__file__).resolve().parents[2] / "shared"
SPREAD = ("hardware", "station", "performance", "e2e")
"""Folders of tests that mostly wait for devices, and of those that keep a browser and a station
busy: each is spread over the whole run."""

settings.register_profile("usual", deadline=None)
settings.register_profile("long", max_examples=5_000, deadline=None)
settings.load_profile("usual")


def pytest_addoption(parser: pytest.Parser) -> None:
    """Of the tests with a real browser."""
    parser.addoption(
        "--screenshots",
        action="store_true",
        help="leave a screenshot of every view of the browser tests in test-output/e2e",
    )


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """Spreads the files of some folders over all others: the workers share processors."""
    groups: dict[str, list[list[pytest.Item]]] = {}
    for path, tests in groupby(items, lambda item: item.path):
        folder = path.parent.name
        groups.setdefault(folder if folder in SPREAD else "", []).append(list(tests))
    placed = [
        ((number + 0.5) / len(files), tests)
        for files in groups.values()
        for number, tests in enumerate(files)
    ]
    items[:] = [test for _, tests in sorted(placed, key=lambda one: one[0]) for test in tests]


@pytest.hookimpl(wrapper=True)
def pytest_collection() -> Generator[None, object, object]:
    """Collects without garbage collections, which took half of the time and found nothing."""
    gc.disable()
    try:
        return (yield)
    finally:
        gc.freeze()
        gc.enable()


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


@pytest.fixture(scope="module", params=CRENEL.variants)
def variant(request: pytest.FixtureRequest) -> Iterator[str]:
    """Runs the tests of a module once with each variant of the C loops."""
    with CRENEL.using(request.param):
        yield request.param
