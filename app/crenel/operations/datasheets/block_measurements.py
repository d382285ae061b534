"""A block that a person measured: its certificate, before anything is kept."""

from dataclasses import dataclass
from pathlib import Path

from crenel.formats.certifying.block_certificate import BlockCertificate, certify_measured
from crenel.formats.certifying.block_points import parse_touches, read_touching_arm
from crenel.formats.certifying.block_readings import parse_readings
from crenel.formats.certifying.certificate_notes import certificate_notes
from crenel.formats.datasheets.target import read_block
from crenel.messages.message import Text

READINGS, POINTS = "readings.csv", "points.csv"


@dataclass(frozen=True)
class BlockMeasurement:
    """What ``crenel certificate block`` is given; tables as texts, empty where there is none."""

    drawing: Path
    readings: str
    points: str
    certificate: str
    arm: Path | None = None
    arm_um: float | None = None
    tip_um: float | None = None


@dataclass(frozen=True)
class CertifiedFace:
    """A face of a block along its axis."""

    name: str
    """As in tables of readings: ``edge_1``, ``crest``."""
    drawn_mm: float
    measured_mm: float
    expanded_um: float
    """With k = 2, about the mean of the faces of its axis."""


@dataclass(frozen=True)
class CertifiedTool:
    """The zero error of an instrument, or the diameter of a tip, as found with the block."""

    name: str
    value_mm: float
    expanded_um: float
    """With k = 2."""


@dataclass(frozen=True)
class BlockCertificateView:
    """The certificate of a block before it is kept."""

    document: str
    """``object.json``."""
    faces: tuple[CertifiedFace, ...]
    tools: tuple[CertifiedTool, ...]
    notes: tuple[Text, ...]


def certify_measurement(measured: BlockMeasurement) -> BlockCertificate:
    """The certificate, as the command makes it of files.

    Raises:
        OperationError: as ``certify_block`` and ``read_touching_arm``.
    """
    block = read_block(measured.drawing)
    readings = parse_readings(measured.readings, Path(READINGS), block) if measured.readings else ()
    by = None
    if measured.arm is not None:
        by = read_touching_arm(measured.arm, measured.arm_um, measured.tip_um)
    touched = parse_touches(measured.points, Path(POINTS), block, by) if measured.points else None
    return certify_measured(block, readings, touched, measured.certificate)


def view_certificate(made: BlockCertificate) -> BlockCertificateView:
    """What the page shows of it."""
    return BlockCertificateView(
        document=made.document.text(),
        faces=tuple(
            CertifiedFace(name, drawn_mm, found_mm, 2e3 * sd_mm)
            for name, drawn_mm, found_mm, sd_mm in made.list_faces()
        ),
        tools=tuple(
            CertifiedTool(tool, value_mm, 2e3 * sd_mm)
            for tool, (value_mm, sd_mm) in made.fit.tools.items()
        ),
        notes=tuple(certificate_notes(made)),
    )
