"""The guided sessions: calibration, verification, performance tests, and checks of the arm.

A session is a journal of rows; its state is the fold of them. ``common`` has what all share,
``gauge`` what verification and performance tests do.
"""
