"""The browser's types of the arm's flows and the 3D view are the same as the server's shapes."""

import pytest

from app.api import health as health_routes
from app.api import notifications as telling
from app.guide.arm import state, view
from app.guide.verify import view as verify_view
from app.monitoring import health
from app.monitoring import log_store as log_book
from app.station import working_distance as distance
from app.station.view3d import cloud_colouring as painter
from app.station.view3d import shape_fits as fits
from app.station.view3d import view_controller as viewing
from app.store import backup
from app.supervision import messages
from app.supervision import notifications as notices
from app.supervision import remote_stations as fleet
from app.wire import schema as verify_schema
from tests.api import test_types

SHAPES: dict[str, dict[str, type]] = {
    "armTypes.ts": {
        "JointSwing": view.JointSwing,
        "Artefact": state.Artefact,
        "SeatLine": view.SeatLine,
        "Before": view.BeforeAfter,
        "ParameterLine": view.ParameterLine,
        "KeptLine": view.FixedParameterLine,
        "CorrelatedLine": view.CorrelatedLine,
        "ArmResult": view.ArmResult,
        "TipResult": view.TipResult,
        "TipCheckSummary": view.TipCheckSummary,
        "IdentificationSummary": view.IdentificationSummary,
        "ArmPicture": view.ArmPicture,
        "ArmView": view.ArmView,
        "ArmCheckSummary": view.ArmCheckSummary,
    },
    "verifyTypes.ts": {
        "GaugeOption": verify_view.GaugeOption,
        "TouchLine": verify_view.TouchLine,
        "CloudLine": verify_view.CloudLine,
        "FigureLine": verify_view.FigureLine,
        "VerdictLine": verify_view.VerdictLine,
        "VerifyPicture": verify_view.VerifyPicture,
        "VerifyView": verify_view.VerifyView,
        "VerificationSummary": verify_schema.VerificationSummary,
        "StudyState": verify_schema.StudyState,
    },
    "viewTypes.ts": {
        "Legend": painter.Legend,
        "ShownScan": viewing.VisibleScan,
        "Figure": fits.ShapeParameter,
        "Fitted": fits.FittedShape,
        "Distance": distance.Distance,
        "ViewState": viewing.ViewState,
    },
    "watchTypes.ts": {
        "DeviceReport": messages.DeviceReport,
        "ActivityReport": messages.ActivityReport,
        "CalibrationReport": messages.CalibrationReport,
        "VerificationReport": messages.VerificationReport,
        "Alarm": messages.Alarm,
        "StationReport": messages.StationReport,
        "StationEvent": messages.StationEvent,
        "StationShown": fleet.RemoteStation,
        "Told": notices.Notice,
        "HealthItem": health.HealthItem,
        "Health": health.Health,
        "BackupMade": backup.BackupRecord,
        "BackupState": health_routes.BackupState,
        "HealthView": health_routes.HealthView,
        "LogLine": log_book.LogLine,
        "Notifications": telling.Notifications,
        "Scraper": telling.ApiTokenSummary,
    },
}


def interfaces_of(file: str, monkeypatch: pytest.MonkeyPatch) -> dict[str, str]:
    monkeypatch.setattr(test_types, "TYPES", (test_types.API / file,))
    return test_types.interfaces()


@pytest.mark.parametrize("file", SHAPES)
def test_every_interface_has_its_shape(file: str, monkeypatch: pytest.MonkeyPatch) -> None:
    assert set(interfaces_of(file, monkeypatch)) == set(SHAPES[file])


@pytest.mark.parametrize(
    ("file", "name"), [(file, name) for file, shapes in SHAPES.items() for name in shapes]
)
def test_a_shape_has_the_fields_of_its_interface(
    file: str, name: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    test_types.assert_same(SHAPES[file][name], interfaces_of(file, monkeypatch)[name])
