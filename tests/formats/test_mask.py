"""Zones in which nothing is measured, and the operator's settings as files."""

import json
from pathlib import Path

import cv2
import numpy as np
import pytest
from pydantic import ValidationError

from crenel.errors import OperationError
from crenel.formats.settings.mask import Mask
from crenel.formats.settings.scan_settings import AUTOMATIC, ScanSettings
from crenel.formats.settings.sync import Sync
from crenel.metrology.stripe import StripeSettings
from crenel.metrology.time_delay.course import NO_DELAY
from crenel.store.store import SettingsStore
from tests.cli.test_cli import crenel, refused

WIDTH, HEIGHT = 200, 100
ZONE = [[50.0, -5.0], [120.0, -5.0], [120.0, 110.0], [50.0, 110.0]]


def written(path: Path, **change: object) -> Path:
    fields: dict[str, object] = {"width_px": WIDTH, "height_px": HEIGHT, "zones": [ZONE]}
    path.write_text(json.dumps({"format": "crenel/mask", "version": 1, **fields, **change}))
    return path


@pytest.fixture
def picture(tmp_path: Path) -> Path:
    rows = np.arange(HEIGHT)[:, None]
    grey = 10 + 180 * np.exp(-((rows - (40 + 0.1 * np.arange(WIDTH))) ** 2) / 8)
    noise = np.random.default_rng(0).normal(0, 1, grey.shape)
    path = tmp_path / "stripe.png"
    cv2.imwrite(str(path), np.clip(np.rint(grey + noise), 0, 255).astype(np.uint8))
    return path


def test_nothing_is_extracted_inside_a_zone(picture: Path, tmp_path: Path) -> None:
    mask, output = written(tmp_path / "mask.json"), tmp_path / "stripe.csv"
    assert crenel("extract", picture, "--mask", mask, "-o", output).exit_code == 0
    u = np.loadtxt(output, delimiter=",", skiprows=1)[:, 0]
    assert not ((u >= 50) & (u <= 120)).any()
    assert np.isin(np.arange(5, 46), u).all()
    assert np.isin(np.arange(125, 195), u).all()


def test_a_mask_of_another_picture_is_refused(picture: Path, tmp_path: Path) -> None:
    mask = written(tmp_path / "mask.json", width_px=640)
    assert "the mask is for 640" in refused("extract", picture, "--mask", mask)
    whole = written(tmp_path / "all.json", zones=[[[-9, -9], [300, -9], [300, 300], [-9, 300]]])
    assert "outside the mask" in refused("extract", picture, "--mask", whole)


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({"zones": [ZONE[:2]]}, "zones"),
        ({"zones": [[[0, 0], [10, 10], [20, 20]]]}, "zone 1 has no area"),
        ({"zones": [ZONE, [[300, 0], [310, 0], [310, 20]]]}, "zone 2 lies outside"),
        ({"zones": [ZONE] * 33}, "zones"),
        ({"zones": [[[0, 0], [1e9, 0], [5, 5]]]}, "zone 1 reaches far"),
        ({"zones": [[["a", 0], [9, 0], [5, 5]]]}, "number"),
        ({"height_px": 0}, "height_px"),
        ({"format": "crenel/sensor"}, "format is"),
    ],
)
def test_odd_masks_are_refused(change: dict[str, object], words: str, tmp_path: Path) -> None:
    with pytest.raises(OperationError, match=words):
        Mask.read(written(tmp_path / "mask.json", **change))


def settings(**change: object) -> ScanSettings:
    mask = Mask(width_px=WIDTH, height_px=HEIGHT, zones=(((0, 0), (9, 0), (9, 9)),))
    sync = Sync(
        delay_ms=4.2,
        standard_uncertainty_ms=0.1,
        frames=100,
        reversals=5,
        seconds=4.0,
        speed_mm_s=30.0,
        rms_without_um=90.0,
        rms_um=15.0,
        arm_serial="A-1",
        sensor_serial="S-1",
    )
    held = {"threshold": 12, "min_width_px": 2.5, "choice": "first", "mask": mask, "sync": sync}
    return ScanSettings.model_validate({**held, **change})


def test_each_of_several_sensors_has_its_own_exposure(tmp_path: Path) -> None:
    path = tmp_path / "scan_settings.json"
    path.write_text('{"format": "crenel/scan-settings", "version": 1, "exposure_us": 2000}')
    earlier = ScanSettings.read(path)
    assert earlier.exposure_of_us("") == 2000
    assert earlier.exposure_of_us("left") is None
    assert "sensor_exposures_us" not in earlier.text()
    changed = earlier.with_exposure_us("left", 700.0).with_exposure_us("right", 900.0)
    changed.write(path)
    kept = ScanSettings.read(path)
    assert [kept.exposure_of_us(name) for name in ("", "left", "right")] == [2000, 700, 900]
    only_right = kept.with_exposure_us("left", None)
    assert only_right.sensor_exposures_us == {"right": 900}
    assert only_right.with_exposure_us("right", None) == earlier
    with pytest.raises(ValidationError, match="right"):
        settings(sensor_exposures_us={"right": -1})


def test_settings_survive_a_restart_and_spoilt_ones_are_reported(tmp_path: Path) -> None:
    assert SettingsStore(tmp_path).read() == AUTOMATIC
    SettingsStore(tmp_path).save(settings())
    again = SettingsStore(tmp_path)
    assert again.read() == settings()
    assert again.trouble is None
    assert again.read().stripe == StripeSettings(12.0, 2.5, choice="first")
    (tmp_path / "scan_settings.json").write_text("{")
    spoilt = SettingsStore(tmp_path)
    assert spoilt.read() == AUTOMATIC
    assert spoilt.trouble is not None


def test_a_delay_of_other_devices_is_not_used() -> None:
    held = settings()
    assert held.delay_of("A-1", "S-1").delay_ns == held.delay_of("A-1", "").delay_ns == 4_200_000
    assert held.delay_of("A-2", "S-1") == AUTOMATIC.delay_of("A-1", "S-1") == NO_DELAY


def test_a_recording_says_how_its_stripes_were_extracted() -> None:
    reported = json.loads(settings().extraction_text)
    assert (reported["threshold"], reported["choice"]) == (12, "first")
    assert Mask.model_validate(reported["mask"]) == settings().mask
    assert AUTOMATIC.extraction_text == ""
