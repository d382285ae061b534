"""The guided sessions: calibration, verification, and checks of the arm.

A session is a journal of rows; its state is the fold of them. ``common`` has what the three share.
"""
