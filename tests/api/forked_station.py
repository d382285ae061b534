"""The bench's station as a process that begins in a moment."""

from collections.abc import Mapping, Sequence

from tests.bench.faults.station import StationProcess
from tests.forked import ForkedProgram


class ForkedStation(StationProcess):
    """A station as the bench starts it, but for the time that the imports take."""

    def _launch(
        self, arguments: Sequence[str], environment: Mapping[str, str], user: int | None
    ) -> ForkedProgram:
        if environment or user is not None:
            raise ValueError("a forked station has the environment and the user of the tests")
        return ForkedProgram("tests.bench.faults.served", arguments, output=self._output)
