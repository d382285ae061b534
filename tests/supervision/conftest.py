"""A broker for the tests of supervision."""

import os
from collections.abc import Iterator

import pytest

from tests.bench.faults.broker.mosquitto import BINARY, Mosquitto


@pytest.fixture(scope="module")
def broker(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Mosquitto]:
    if BINARY is None:
        if os.environ.get("CI"):
            pytest.fail("mosquitto is not installed, and CI must run these tests")
        pytest.skip("mosquitto is not installed")
    with Mosquitto(tmp_path_factory.mktemp("broker")) as running:
        yield running
