"""Scanning: from frames to a recording and a cloud.

``scanner`` starts and stops; ``pipeline`` takes frames, extracts stripes (``extraction``),
records them (``recorder``) and makes points (``points``); ``storage`` has the folders of scans.
"""
