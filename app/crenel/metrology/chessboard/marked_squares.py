"""Whether the white squares of a board hold ArUco markers, of whatever dictionary."""

import cv2
import numpy as np

from crenel.metrology.image import Image, saturation_level

LARGEST = (
    "DICT_4X4_1000",
    "DICT_5X5_1000",
    "DICT_6X6_1000",
    "DICT_7X7_1000",
    "DICT_APRILTAG_36h11",
)
"""Dictionaries that hold the smaller ones of their size."""
FEWEST = 4
"""Markers of one dictionary that are no chance."""


def has_markers(image: Image) -> bool:
    """Whether a picture (H, W) of 8 to 16 bits shows several markers of one dictionary."""
    full = image.astype(np.float64) * (255.0 / saturation_level(image))
    grey = np.clip(full, 0, 255).astype(np.uint8)
    for name in LARGEST:
        dictionary = cv2.aruco.getPredefinedDictionary(getattr(cv2.aruco, name))
        _, ids, _ = cv2.aruco.ArucoDetector(dictionary).detectMarkers(grey)
        if ids is not None and len(np.unique(ids)) >= FEWEST:
            return True
    return False
