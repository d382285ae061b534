"""The record of a verification, and the nominal of its gauge."""

import json
from pathlib import Path
from typing import Any

import pytest

from crenel.errors import OperationError
from crenel.gauges.plan.document_gauge import DEFAULT_LIMITS, VerificationLimits, read_gauge
from crenel.gauges.quick.document import VerificationFile, read_verification, write_verification
from crenel.metrology.decision import EXPANDED_K2
from tests.formats.builders import edit_json

RECORD: dict[str, Any] = {
    "id": "20261121-101500-aa11",
    "station": "Room 2",
    "operator": "Anna",
    "started_at": "2026-11-21T10:15:00Z",
    "accepted_at": "2026-11-21T10:20:00Z",
    "gauge": {"shape": "sphere", "name": "Sphere", "radius_mm": 12.7, "form_um": 1.0},
    "serial_numbers": {"arm": "A-1", "sensor": "S-1", "object": "B-1"},
    "calibration": {"id": "c", "name": "C", "accepted_at": "2026-11-20", "total_um": 33.0},
    "placing": {
        "touches": 7,
        "rms_um": 8.0,
        "point_mm": [1, 2, 3],
        "radius_mm": 12.702,
        "standard_uncertainty_um": 6.0,
    },
    "clouds": [
        {
            "name": "Cloud 1",
            "recording": "cloud-1/scan.mcap",
            "taken_at": "2026-11-21T10:16:00Z",
            "seconds": 8.0,
            "frames": 200,
            "points": 4000,
            "used": 3900,
            "rms_um": 20.0,
            "form_um": 80.0,
            "centre_mm": [1, 2, 3],
            "radius_mm": 12.72,
            "radius_error_um": -20.0,
            "centre_error_um": 50.0,
        }
    ],
    "figures": [
        {
            "name": "radius_error",
            "title": "Radius error",
            "unit": "µm",
            "value": -20.0,
            "expanded_uncertainty": 6.0,
            "limit": 100.0,
            "decision": "pass",
            "reason": "-20 µm, within 100 µm by more than 6 µm.",
            "clouds": [-20.0],
        }
    ],
    "verdict": {"result": "pass", "text": "It keeps its limits.", "reasons": ["-20 µm."]},
    "inputs": [{"file": "cloud-1/scan.mcap", "sha256": "0" * 64}],
    "software": {"name": "crenel", "version": "1"},
}


def test_a_record_reads_back_as_it_was_written(tmp_path: Path) -> None:
    document = VerificationFile.model_validate(RECORD)
    write_verification(tmp_path, document)
    assert read_verification(tmp_path) == document
    fields = json.loads((tmp_path / "verification.json").read_text())
    assert (fields["format"], fields["k"]) == ("crenel/verification", 2)


def test_an_older_record_was_judged_by_its_expanded_uncertainty() -> None:
    document = VerificationFile.model_validate(RECORD)
    assert document.rule.rule == EXPANDED_K2
    (figure,) = document.figures
    assert (figure.test_uncertainty, figure.judged_by) == (None, "measurement")
    assert (document.filters, document.clouds[0].form_all_um) == (None, None)


def test_a_record_without_clouds_is_none(tmp_path: Path) -> None:
    write_verification(tmp_path, VerificationFile.model_validate(RECORD))
    edit_json(tmp_path / "verification.json", lambda fields: fields.update(clouds=[]))
    with pytest.raises(OperationError, match="clouds"):
        read_verification(tmp_path)


def gauge(tmp_path: Path, **fields: object) -> Path:
    path = tmp_path / "g.nominal.json"
    path.write_text(json.dumps({"format": "crenel/nominal", "version": 1, **fields}))
    return path


def test_a_gauge_needs_no_place_but_a_sphere_its_size(tmp_path: Path) -> None:
    found = read_gauge(gauge(tmp_path, shape="plane", limits={"form": 40}))
    with_form = DEFAULT_LIMITS.model_copy(update={"form": 40.0})
    assert found.limits.with_defaults(DEFAULT_LIMITS) == with_form
    with pytest.raises(OperationError, match="radius_mm"):
        read_gauge(gauge(tmp_path, shape="sphere"))
    with pytest.raises(OperationError, match="radius_mm"):
        read_gauge(gauge(tmp_path, shape="sphere", radius_mm="12"))
    with pytest.raises(OperationError, match="shape"):
        read_gauge(gauge(tmp_path, shape="cone"))


def test_limits_that_say_nothing_leave_the_others() -> None:
    assert VerificationLimits().with_defaults(DEFAULT_LIMITS) == DEFAULT_LIMITS
