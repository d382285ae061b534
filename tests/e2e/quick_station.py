"""The bench's simulated station whose operator takes few pictures: ``python -m`` this, a folder."""

import typer

from crenel.guide.calibration.automatic import simulated_operator
from tests.bench.faults.served import serve

simulated_operator.POSES, simulated_operator.BOARD_POSES = 4, 8

if __name__ == "__main__":
    typer.run(serve)
