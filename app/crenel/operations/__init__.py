"""Background tasks: publishing, checks and recovery.

``context`` holds the parts of the station. ``services`` starts and stops the others:
``publishers`` keeps the topics up to date, ``health_checks`` and ``status_report`` describe the
state of the station, ``recovery`` lists what a killed process left, ``calibration_in_use`` and
``unreadable_files`` check the files on the disk.
"""
