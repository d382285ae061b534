"""Gauge tests: what the calibrated system measures on calibrated artefacts.

A folder for each kind: ``sphere``, ``length``, ``plane``, ``contact``, and ``quick``, the quick
verification. What all share is in ``plan`` (what is tested, on which artefacts, with which
limits), ``session`` (what is entered, touched and scanned), ``judgement`` (values and decisions),
``report`` and ``exchange`` (files for other programs). The modules beside these folders put the
kinds together; start reading at ``guide.py`` and ``evaluate.py``.

The first word of a module's or a folder's name is its layer: ``maths`` takes arrays, ``document``
is a file format, ``evaluate`` works on files, ``guide`` leads the operator, ``report`` prints,
``routes`` answer browsers, ``command_line`` has commands; ``exchange`` has documents, ``session``
belongs to the guides. ``tests/structure/test_imports.py`` checks that each imports only what is
below it.
"""
