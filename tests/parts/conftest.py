"""The station that tests of the guided inspection ask."""

from tests.api.conftest import calibration, server

__all__ = ["calibration", "server"]
