"""The crenellated block in an image.

Entry point: ``detect_block``. ``search`` finds poses that explain the line segments, ``edges``
measures all edges from there, ``acceptance`` decides, and ``failure_evidence`` and ``errors`` say
why not.
"""
