"""What a block's certificate says of its uncertainties, and of the drawing."""

import numpy as np

from crenel.formats.certifying.block_certificate import BlockCertificate
from crenel.formats.certifying.block_readings import face_name
from crenel.messages.message import Text, message, quantity
from crenel.messages.uncertainty import uncertainty_quantity
from crenel.metrology.calibration.observation_model import coordinates


def certificate_notes(made: BlockCertificate) -> list[Text]:
    """What the uncertainties mean, and by what they grew."""
    notes: list[Text] = [message("coordinates-about-mean-of-faces")]
    beyond = _faces_beyond_tolerance(made)
    if beyond:
        tolerance = quantity(made.drawing.made_within_mm, "mm", 3)
        faces = ", ".join(beyond)
        text = message("faces-beyond-tolerance", faces=faces, tolerance=tolerance)
        notes.append(text)
    if made.fit.variance_factor > 1:
        times = quantity(made.fit.variance_factor**0.5, "", 1)
        notes.append(message("readings-scatter-more", times=times))
    touched = made.fit.touched
    if touched is not None and touched.variance_factor > 1:
        times = quantity(touched.variance_factor**0.5, "", 1)
        notes.append(message("touches-scatter-more", times=times))
    if made.touches is not None and made.touches.arm_error_mm is not None:
        error = uncertainty_quantity(1e3 * made.touches.arm_error_mm, "µm")
        notes.append(message("errors-of-links-counted", error=error))
    return notes


def _faces_beyond_tolerance(made: BlockCertificate) -> list[str]:
    """Those further from the drawing than it allows, and than their uncertainty."""
    if not made.drawing.is_nominal:
        return []
    edges = len(made.document.edges_x_mm)
    off = coordinates(made.document.block()) - coordinates(made.drawing)
    allowed = made.drawing.made_within_mm + 2 * made.fit.sds_mm
    return [face_name(face, edges) for face in np.flatnonzero(np.abs(off) > allowed).tolist()]
