"""``crenel bench``: the tables of docs/accuracy.md, measured on the machine it runs on.

``group`` has the command group, ``metrology``, ``stripe``, ``station`` and ``fleet`` its commands;
importing the package registers them in this order.
"""

from crenel.cli.bench import metrology, stripe, station, fleet  # isort: skip
from crenel.cli.bench.group import bench

__all__ = ["bench", "fleet", "metrology", "station", "stripe"]
