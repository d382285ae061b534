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
WAITING = {"hardware", "station"}
"""Folders of tests that mostly wait for devices."""

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
    """Spreads the files whose tests mostly wait over all others: the workers share processors."""
    files = [list(tests) for _, tests in groupby(items, lambda item: item.path)]
    waiting = [tests for tests in files if tests[0].path.parent.name in WAITING]
    others = [tests for tests in files if tests[0].path.parent.name not in WAITING]
    placed = [
        ((number + 0.5) / len(group), tests)
        for group in (waiting, others)
        for number, tests in enumerate(group)
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
