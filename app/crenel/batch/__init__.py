"""Work over many recordings, on Dask: rebuilt, studied and verified from archives and data folders.

Start at ``rebuild.py``. ``places`` finds the records of a station, ``recordings`` chooses among
them, ``calibrations`` reads what they are rebuilt with. Each recording is a ``Task``
(``task.py``) with a key of all that determines its result; ``runner`` has the workers of a
``cluster`` do all of them, each once, and ``results`` keeps what they made.
``patience`` waits for stores that cannot be reached.
"""
