"""The crenellated block in an image.

Entry point: ``detect_block``. ``search`` finds poses that explain the line segments, ``edges``
measures all edges for such a pose, ``acceptance`` decides, and ``failure_evidence`` and ``errors``
explain a failed detection.
"""
