"""``python -m tests.bench``: the tables of docs/accuracy.md, measured on the machine it runs on.

``group`` has the command group, ``metrology``, ``stripe``, ``station`` and ``fleet`` its commands;
importing the package registers them in this order.
"""

from tests.bench.commands import metrology, stripe, station, fleet  # isort: skip
from tests.bench.commands.group import bench

__all__ = ["bench", "fleet", "metrology", "station", "stripe"]
