"""The stripe's place by Crenel's extraction, and by two common ways beside it."""

from collections.abc import Callable

import cv2
import numpy as np

from crenel.metrology.image import Image
from crenel.metrology.stripe import extract_stripe
from crenel.metrology.transforms import Floats
from tests.bench.stripe.frames import READ

Line = tuple[Floats, Floats]
Method = Callable[[Image], Line]


def fit_blurred_parabola(image: Image) -> Line:
    """Vertex of the parabola through every column's highest pixel after Gaussian blur."""
    smooth = cv2.GaussianBlur(image, (1, 9), sigmaX=0.1, sigmaY=2.0).astype(np.float32)
    along = np.arange(image.shape[1])
    top = np.clip(smooth.argmax(axis=0), 1, image.shape[0] - 2)
    a, b, c = (smooth[top + k, along].astype(np.float64) for k in (-1, 0, 1))
    bend = a - 2 * b + c
    vertex = np.where(bend < 0, 0.5 * (a - c) / np.where(bend < 0, bend, 1.0), 0.0)
    kept = b > 30
    return along[kept].astype(np.float64), (top + np.clip(vertex, -1, 1))[kept]


def centroid(image: Image) -> Line:
    """Centre of gravity about every column's highest pixel."""
    along = np.arange(image.shape[1])
    top = np.clip(image.argmax(axis=0), 6, image.shape[0] - 7)
    rows = top + np.arange(-6, 7)[:, None]
    window = image[rows, along].astype(np.float64)
    light = np.maximum(window - window.min(axis=0) - 3 * READ, 0.0)
    kept = window[6] > 30
    total = np.maximum(light.sum(axis=0), 1e-9)
    return along[kept].astype(np.float64), ((light * rows).sum(axis=0) / total)[kept]


def crenel_line(image: Image) -> Line:
    stripe = extract_stripe(image)
    return stripe.u, stripe.v


METHODS: tuple[Method, ...] = (crenel_line, fit_blurred_parabola, centroid)
