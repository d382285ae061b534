"""The guided calibration.

``guide`` runs a session: ``commands`` append to the journal, ``state`` folds it, ``rules`` say what
is possible, ``flow`` and ``steps`` make the view, ``solve`` computes the result.
"""
