"""What runs beside the operator: what is published, checked and recovered.

``context`` holds the parts of the one station. ``services`` starts and stops the others:
``publishers`` and ``ticker`` keep the topics up to date, ``health_checks`` and ``status_report``
say how the station is, ``recovery`` lists what a killed process left,
``calibration_in_use`` and ``unreadable_files`` look at what is on the disk.
"""
