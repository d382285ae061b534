"""What the guided sessions share.

``guided_session`` appends to the ``journal`` and publishes the ``view``; a ``flow`` says how its
kind folds, and by which ``rules``. ``commands`` come from the browser, whose ``arguments`` are
checked, and from the arm's ``buttons``. ``validity`` says what is valid and due.
"""
