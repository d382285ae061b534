"""The folder of a guided session (docs/formats.md), which can be rebuilt from its files alone."""

from collections.abc import Mapping, Sequence
from datetime import UTC, datetime
from pathlib import Path

import numpy as np

from crenel.errors import OperationError
from crenel.formats.atomic_write import ensure_folder, write_atomically
from crenel.formats.datasheets.arm import read_any_arm
from crenel.formats.datasheets.sensor import SelectedPart, read_sensor
from crenel.formats.datasheets.target import read_object
from crenel.formats.images import write_png
from crenel.formats.io_errors import convert_all_errors, convert_io_errors
from crenel.formats.json_document import file_sha256
from crenel.formats.open_file import read_bounded
from crenel.formats.results.acceptance import ACCEPTANCE, Acceptance, ComparisonPart
from crenel.formats.results.calibration import CALIBRATION
from crenel.formats.results.decision_rule import RulePart
from crenel.formats.session.calibration_session import (
    ARM,
    IMAGES,
    OBJECT,
    PICTURES,
    PROBING,
    SENSOR,
    contact_readings,
    write_contacts,
)
from crenel.formats.session.pose_pictures import ImageRow, image_row, write_images
from crenel.formats.settings.line_settings import (
    LINE,
    LineSettings,
    SessionLine,
    read_session_line,
)
from crenel.guide.calibration.live import SelectedDatasheets
from crenel.guide.calibration.state import Contact
from crenel.guide.calibration.state import PoseCapture as Captured
from crenel.guide.common.datasheet_library import DatasheetLibrary
from crenel.guide.common.guided_session import Provenance
from crenel.guide.common.result_view import CalibrationResult
from crenel.metrology.decision import DecisionRule
from crenel.station.devices.capture import Capture

CAMERA_FROM = "camera-from.json"
"""The calibration whose camera and mounting the session keeps."""


class SessionFolder:
    """Writes what the journal says into the session's folder; the journal is the record."""

    def __init__(self, path: Path) -> None:
        self.path = path
        self.calibration = path / CALIBRATION
        self.camera = path / CAMERA_FROM

    def keep_datasheets(self, library: DatasheetLibrary, choices: Mapping[str, str]) -> None:
        """Copies the chosen arm, object and sensor, which the session uses from now on."""
        with convert_io_errors(self.path):
            ensure_folder(self.path / PICTURES)
            sources = (
                (library.arms[choices["arm"]].path, ARM),
                (library.objects[choices["object"]].path, OBJECT),
                (library.sensors[choices["sensor"]].path, SENSOR),
            )
            for source, name in sources:
                write_atomically(self.path / name, read_bounded(source))

    def keep_camera(self, source: Path | None) -> None:
        """Copies the calibration whose camera and mounting are kept; None: nothing is kept."""
        with convert_io_errors(self.path):
            if source is None:
                self.camera.unlink(missing_ok=True)
            else:
                write_atomically(self.camera, read_bounded(source))

    def datasheets(self) -> SelectedDatasheets:
        """The session's own copies; None for what cannot be read any more."""
        try:
            with convert_all_errors(self.path):
                return SelectedDatasheets(
                    read_any_arm(self.path / ARM),
                    read_object(self.path / OBJECT),
                    read_sensor(self.path / SENSOR),
                )
        except OperationError:
            return SelectedDatasheets(None, None, None)

    def keep_line(self, line: SessionLine) -> None:
        """Writes what is set of the laser's line."""
        line.write(self.path / LINE)

    def line(self) -> LineSettings:
        """What is set of the laser's line; raises ``OperationError`` if it cannot be read."""
        return read_session_line(self.path)

    def keep_selected(self, selected: SelectedPart | None) -> None:
        """Notes in ``sensor.json`` what of a colour camera the pictures are."""
        path = self.path / SENSOR
        sensor = read_sensor(path)
        if sensor.selected != selected:
            sensor.model_copy(update={"selected": selected}).write(path)

    def keep_contacts(self, contacts: Sequence[Contact]) -> None:
        """Brings ``probing.csv`` up to date; without points there is none."""
        path = self.path / PROBING
        if not contacts:
            path.unlink(missing_ok=True)
            return
        faces = tuple(contact.face for contact in contacts)
        readings = np.array([contact.reading for contact in contacts])
        write_contacts(path, contact_readings(faces, read_any_arm(self.path / ARM), readings))

    def keep_capture(self, number: int, capture: Capture) -> dict[str, str | None]:
        """Writes the pictures of a capture; their names relative to the folder."""
        names: dict[str, str | None] = {"ambient": None, "laser": None}
        for lighting, frame in (("ambient", capture.ambient), ("laser", capture.laser)):
            if frame is not None:
                shown = "both" if capture.lighting == "both" else lighting
                name = f"{PICTURES}/capture-{number}-{shown}.png"
                write_png(self.path / name, frame.image)
                names[lighting] = name
        return names

    def keep_images(self, pictures: Sequence[Captured]) -> None:
        """Brings ``images.csv`` up to date with the captures that count, one pose each."""
        path = self.path / IMAGES
        if not pictures:
            path.unlink(missing_ok=True)
            return
        rows: list[ImageRow] = []
        arm = read_any_arm(self.path / ARM)
        for picture in pictures:
            lightings = [(picture.ambient, "ambient"), (picture.laser, "laser")]
            if picture.lighting == "both":
                lightings = [(picture.ambient, "both")]
            reading = np.array(picture.reading)
            rows += [
                image_row(picture.number, name, lighting, arm, reading)
                for name, lighting in lightings
                if name is not None
            ]
        write_images(path, rows)

    def keep_acceptance(
        self, name: str, result: CalibrationResult, signing: Provenance, rule: DecisionRule
    ) -> None:
        """Writes who puts the session's calibration to use, and by which limits and rule."""
        moved = result.comparison
        compared = (
            ComparisonPart(name=moved.with_name, rms_um=moved.rms_um, max_um=moved.max_um)
            if moved is not None
            else None
        )
        Acceptance(
            name=name,
            accepted_at=datetime.now(UTC).isoformat(timespec="seconds"),
            operator=signing.operator(),
            station=signing.station,
            simulated=signing.is_simulated(),
            calibration_sha256=file_sha256(self.calibration),
            good_um=result.good_um,
            usable_um=result.usable_um,
            rule=RulePart.of(rule),
            temperature_c=signing.temperature_c(),
            compared=compared,
        ).write(self.path / ACCEPTANCE)

    def image(self, name: str) -> Path | None:
        """The path of one of the session's pictures by its bare name."""
        folder = self.path / PICTURES
        if not folder.is_dir():
            return None
        return next((path for path in folder.iterdir() if path.name == name), None)
