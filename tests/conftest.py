"""Fixtures that all tests share."""

import gc
import os
import sys
from collections.abc import Generator, Iterator
from pathlib import Path

import pytest
from hypothesis import settings

import crenel  # noqa: F401  # sets the numerical libraries' threads before numpy is loaded
from crenel.native.library import CRENEL
from tests.running.leaks import LeakCheck
from tests.running.pools import Controller, Worker, add_within, pytest_xdist_auto_num_workers

__all__ = ["pytest_xdist_auto_num_workers"]

SHARED = Path(__file__).resolve().parents[2] / "shared"
# the same examples each time: a change is not blamed for what chance found; nightly tries others
settings.register_profile("usual", deadline=None, derandomize=True)
settings.register_profile("long", max_examples=5_000, deadline=None)
settings.load_profile("usual")
# where the environment forbids it, a thousand processes would each compile the same modules
os.environ.pop("PYTHONDONTWRITEBYTECODE", None)
sys.dont_write_bytecode = False


def pytest_addoption(parser: pytest.Parser) -> None:
    """Of the workers, and of the tests with a real browser."""
    add_within(parser)
    parser.addoption(
        "--screenshots",
        action="store_true",
        help="leave a screenshot of every view of the browser tests in test-output/e2e",
    )


def pytest_configure(config: pytest.Config) -> None:
    """In a process that starts workers, their controller; in each that runs tests, their pool."""
    if not hasattr(config, "workerinput") and config.getoption("tx", None):
        config.pluginmanager.register(Controller(config))
    else:
        config.pluginmanager.register(Worker(config))
        config.pluginmanager.register(LeakCheck(), LeakCheck.__name__)


@pytest.hookimpl(wrapper=True)
def pytest_collection() -> Generator[None, object, object]:
    """Collects without garbage collections, which took half of the time and found nothing."""
    gc.disable()
    try:
        return (yield)
    finally:
        gc.freeze()
        gc.enable()


@pytest.fixture(scope="session", autouse=True)
def temporary_folder(
    request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory
) -> None:
    """Temporary files of this process and of those that it starts lie in one folder."""
    check = request.config.pluginmanager.get_plugin(LeakCheck.__name__)
    assert isinstance(check, LeakCheck)
    check.begin(tmp_path_factory.getbasetemp() / "temporary")


@pytest.fixture(autouse=True)
def patience_with_pictures(monkeypatch: pytest.MonkeyPatch) -> None:
    """A busy machine receives no whole picture for longer than one that is not."""
    for module, name in (("camera_source", "INCOMPLETE_S"), ("driver", "FIRST_WITHIN_S")):
        if (found := sys.modules.get(f"crenel_hardware.sensor.genicam.{module}")) is not None:
            monkeypatch.setattr(found, name, 60.0)


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
