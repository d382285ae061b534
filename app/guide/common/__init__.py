"""What the guided sessions share.

``guided_session`` appends to the ``journal`` and publishes the ``view``. ``arguments`` checks what
a command carries, ``buttons`` hears the arm's buttons, ``validity`` says what is valid and due.
"""
