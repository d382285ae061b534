"""The station that tests of the guided sessions on gauges ask."""

from tests.api.conftest import calibration, server

__all__ = ["calibration", "server"]
