"""arm.json, object.json, sensor.json, nominals and calibrations: read back, and refused."""

import json
import os
from contextlib import suppress
from dataclasses import astuple, replace
from hashlib import sha256
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from crenel.errors import OperationError
from crenel.formats.datasheets.arm import parse_any_arm, read_arm
from crenel.formats.datasheets.sensor import SensorDatasheet, read_sensor
from crenel.formats.datasheets.target import read_block, read_object
from crenel.formats.json_document import Document, has_sha256
from crenel.formats.results.calibration import (
    CalibrationFile,
    FindingPart,
    PosePart,
    VerdictPart,
    read_calibration,
)
from crenel.gauges.quick.clouds.document_nominal import read_nominal
from crenel.gauges.quick.document import VerificationVerdict
from crenel.gauges.quick.maths.errors import NominalPlane, NominalSphere
from crenel.messages.message import message, quantity
from crenel.metrology.arm.kinematics import Arm, Joint, Tip, tip_centres
from crenel.metrology.arm.link_error import LinkError
from crenel.metrology.transforms import rigid, rotation_from_vector
from tests.datasheets import write_arm, write_object
from tests.formats.builders import ARM, BLOCK, SENSOR, edit_json, little_calibration, write_session
from tests.refusals import refused_as
from tests.sources import ROOT

DRAWN = ROOT / "frontend/src/datasheets/chainCases.json"
lengths = st.floats(-1e4, 1e4)
angles = st.floats(-6.3, 6.3)
joints = st.builds(
    Joint,
    name=st.text(min_size=1, max_size=5),
    a_mm=lengths,
    alpha_rad=angles,
    d_mm=lengths,
    theta_rad=angles,
    sign=st.sampled_from((1, -1)),
    limits_rad=st.tuples(st.floats(-7, -1), st.floats(1, 7)),
    encoder_sd_rad=st.floats(0, 1e-3),
    error=st.builds(LinkError, *[lengths] * 3, *[angles] * 3),
)
arms = st.builds(
    Arm,
    name=st.text(max_size=10),
    serial_number=st.text(max_size=10),
    # one joint has a length and angles as an arm has them: others are in another unit
    joints=st.lists(joints, min_size=5, max_size=7, unique_by=lambda joint: joint.name).map(
        lambda found: (replace(found[0], a_mm=300.0, alpha_rad=1.5, theta_rad=1.5), *found[1:])
    ),
    tip=st.builds(Tip, lengths, lengths, lengths, st.floats(0.1, 100)),
)


def numbers_of(arm: Arm) -> list[float]:
    found: list[float] = []
    for joint in arm.joints:
        found += [joint.a_mm, joint.alpha_rad, joint.d_mm, joint.theta_rad, float(joint.sign)]
        found += [*joint.limits_rad, joint.encoder_sd_rad, *astuple(joint.error)]
    return [*found, *astuple(arm.tip)]


@given(arms)
@settings(max_examples=40, suppress_health_check=[HealthCheck.function_scoped_fixture])
def test_an_arm_reads_back(tmp_path: Path, arm: Arm) -> None:
    write_arm(tmp_path / "arm.json", arm)
    back = read_arm(tmp_path / "arm.json")
    assert (back.name, back.serial_number) == (arm.name, arm.serial_number)
    assert [joint.name for joint in back.joints] == [joint.name for joint in arm.joints]
    np.testing.assert_allclose(numbers_of(back), numbers_of(arm), rtol=1e-14, atol=1e-300)


def test_an_object_reads_back(tmp_path: Path) -> None:
    write_object(tmp_path / "object.json", BLOCK)
    assert read_object(tmp_path / "object.json") == BLOCK


def test_a_sensor_reads_back_and_unknown_fields_are_ignored(tmp_path: Path) -> None:
    path = tmp_path / "sensor.json"
    path.write_text("\ufeff" + json.dumps({**SENSOR, "lens": {"maker": "?"}, "focal_px": 2800}))
    document = read_sensor(path)
    assert isinstance(document, SensorDatasheet)
    assert (document.width_px, document.stripe_axis, document.focal_px) == (64, "u", 2800.0)
    document.write(path)
    assert read_sensor(path) == document


def test_the_samples_nominals_read(samples: Path) -> None:
    assert isinstance(read_nominal(samples / "one-pose/plane.nominal.json"), NominalPlane)
    assert isinstance(read_nominal(samples / "one-pose/sphere.nominal.json"), NominalSphere)


@pytest.mark.parametrize(
    ("spoil", "code", "said"),
    [
        (lambda arm: arm.update(format="crenel/object"), "file-of-another-format", "crenel/arm"),
        (lambda arm: arm.pop("format"), "file-of-another-format", "states no format"),
        (lambda arm: arm.update(version=2), "file-of-another-version", "version is 2"),
        (lambda arm: arm.update(version=True), "file-of-another-version", "True"),
        (lambda arm: arm.update(convention="dh-other"), "field-invalid", "dh-other"),
        (lambda arm: arm.update(convention="pose"), "arm-without-joints", "pose"),
        (lambda arm: arm.update(joints=arm["joints"][:4]), "field-invalid", "not 4"),
        (lambda arm: arm.update(joints={}), "field-invalid", "joints"),
        (lambda arm: arm["joints"][2].pop("d_mm"), "field-missing", "joints[2].d_mm is missing"),
        (lambda arm: arm["joints"][2].update(a_mm="30"), "field-invalid", "joints[2].a_mm is '30'"),
        (lambda arm: arm["joints"][2].update(a_mm=float("nan")), "field-invalid", "finite"),
        (lambda arm: arm["joints"][2].update(a_mm=float("inf")), "field-invalid", "finite"),
        (lambda arm: arm["joints"][2].update(a_mm=10**400), "field-invalid", "joints[2].a_mm"),
        (lambda arm: arm["joints"][2].update(a_mm=True), "field-invalid", "a number"),
        (lambda arm: arm["joints"][2].update(sign=0), "field-invalid", "joints[2].sign is 0"),
        (lambda arm: arm["joints"][0].update(limits_deg=[5, -5]), "field-invalid", "ascend"),
        (
            lambda arm: [one.update(a_mm=one["a_mm"] / 1e3, d_mm=0.3) for one in arm["joints"]],
            "field-invalid",
            "these are metres",
        ),
        (lambda arm: arm["joints"][0].update(encoder_sd_deg=-1), "field-invalid", "encoder_sd_deg"),
        (lambda arm: arm["tip"].update(diameter_mm=0), "field-invalid", "tip.diameter_mm is 0"),
        (lambda arm: arm["joints"][3].update(name="J1"), "field-invalid", "two joints are named"),
        (lambda arm: arm["tip"].update(x_mm=1e300), "field-invalid", "tip.x_mm is 1e+300"),
        (lambda arm: arm.pop("tip"), "field-invalid", "tip is missing"),
    ],
)
def test_a_spoilt_arm_is_refused(tmp_path: Path, spoil: Any, code: str, said: str) -> None:
    path = write_session(tmp_path / "s") / "arm.json"
    edit_json(path, spoil)
    with pytest.raises(OperationError) as refused:
        read_arm(path)
    assert refused.value.code == code
    assert str(path) in str(refused.value.what)
    assert said in refused.value.line
    assert "\n" not in refused.value.line


def test_the_tips_that_the_client_draws_are_those_of_the_kinematics() -> None:
    for case in json.loads(DRAWN.read_text()):
        arm = parse_any_arm(json.dumps(case["document"]), DRAWN)
        assert isinstance(arm, Arm)
        tip_mm = tip_centres(arm, np.deg2rad([case["q_deg"]]))[0]
        np.testing.assert_allclose(tip_mm, case["tip_mm"], atol=1e-6)


@pytest.mark.parametrize("name", ["arm.json", "sensor.json"])
def test_a_serial_number_may_be_missing(tmp_path: Path, name: str) -> None:
    folder = write_session(tmp_path / "s")
    edit_json(folder / name, lambda document: document.pop("serial_number"))
    assert (read_arm(folder / "arm.json").serial_number == "") == (name == "arm.json")
    assert (read_sensor(folder / "sensor.json").serial_number == "") == (name == "sensor.json")


def _as_drawn(block: dict[str, Any], tolerance_mm: float) -> None:
    del block["standard_uncertainty_mm"]
    block["tolerance_mm"] = tolerance_mm


def _with_uncertainties(block: dict[str, Any], count: int = 6, each: float = 0.001) -> None:
    faces = ("front_y_mm", "back_y_mm", "crest_z_mm", "floor_z_mm", "base_z_mm")
    known = {"edges_x_mm": [each] * count, **dict.fromkeys(faces, each / 2)}
    block["standard_uncertainties_mm"] = known


def test_a_block_says_how_well_each_coordinate_is_known(tmp_path: Path) -> None:
    path = write_session(tmp_path / "s") / "object.json"
    edit_json(path, _with_uncertainties)
    np.testing.assert_allclose(read_block(path).sds_mm, [0.001] * 6 + [0.0005] * 5)
    assert not read_block(path).is_nominal
    edit_json(path, lambda block: block.pop("standard_uncertainties_mm"))
    edit_json(path, lambda block: _as_drawn(block, 0.1))
    np.testing.assert_allclose(read_block(path).sds_mm, 0.1 / np.sqrt(3))
    assert read_block(path).is_nominal


@pytest.mark.parametrize(
    ("spoil", "said"),
    [
        (lambda block: block["edges_x_mm"].pop(), "5 edges"),
        (lambda block: block["edges_x_mm"].reverse(), "ascend"),
        (lambda block: block.update(edges_x_mm=[1, 2]), "edges_x_mm"),
        (lambda block: block.update(edges_x_mm=[0, 5, 10, 15]), "mirror image"),
        (lambda block: block.update(crest_z_mm=-1), "crest_z_mm"),
        (lambda block: block.update(front_y_mm=99), "front_y_mm"),
        (lambda block: block.update(standard_uncertainty_mm=2), "micrometres"),
        (lambda block: block.pop("standard_uncertainty_mm"), "exactly one"),
        (lambda block: block.update(tolerance_mm=0.1), "exactly one"),
        (lambda block: _as_drawn(block, 0.5), r"at most 0\.3 mm"),
        (lambda block: _as_drawn(block, 0), "above 0"),
        (lambda block: _with_uncertainties(block, count=5), "5 edges"),
        (lambda block: _with_uncertainties(block, each=0.01), "largest"),
        (lambda block: block.update(kind="chessboard"), "square_mm is missing"),
        (lambda block: block.update(kind="ball"), "ball"),
        (lambda block: block.pop("serial_number"), "serial_number is missing"),
    ],
)
def test_a_spoilt_object_is_refused(tmp_path: Path, spoil: Any, said: str) -> None:
    path = write_session(tmp_path / "s") / "object.json"
    edit_json(path, spoil)
    with pytest.raises(OperationError, match=said) as refused:
        read_object(path)
    assert str(path) in str(refused.value.what)


@pytest.mark.parametrize(
    "text", ["", "{", '{"format": "crenel/arm", "joints": [1', "[]", "7", "\xff"]
)
def test_what_is_not_json_is_refused(tmp_path: Path, text: str) -> None:
    path = tmp_path / "arm.json"
    path.write_bytes(text.encode("latin-1"))
    with pytest.raises(OperationError, match=r"arm\.json"):
        read_arm(path)


def test_a_truncated_arm_is_refused_wherever_it_ends(tmp_path: Path) -> None:
    path = tmp_path / "arm.json"
    write_arm(path, ARM)
    whole = path.read_bytes()
    for length in range(0, len(whole) - 2, 97):
        path.write_bytes(whole[:length])
        with refused_as("file-not-json"):
            read_arm(path)


json_values = st.recursive(
    st.none() | st.booleans() | st.floats() | st.integers() | st.text(max_size=5),
    lambda inner: st.lists(inner, max_size=3) | st.dictionaries(st.text(max_size=5), inner),
    max_leaves=8,
)


@pytest.mark.slow
@given(st.data())
@settings(max_examples=150, suppress_health_check=[HealthCheck.function_scoped_fixture])
def test_any_wrong_value_is_refused_or_harmless(tmp_path: Path, data: st.DataObject) -> None:
    path = tmp_path / "arm.json"
    write_arm(path, ARM)
    fields = json.loads(path.read_text())
    place = data.draw(st.sampled_from(["joints", "tip", "name", "convention"]))
    value = data.draw(json_values)
    if place == "joints" and data.draw(st.booleans()):
        joint = data.draw(st.sampled_from(fields["joints"]))
        joint[data.draw(st.sampled_from(sorted(joint)))] = value
    else:
        fields[place] = value
    path.write_text(json.dumps(fields))
    with suppress(OperationError):
        assert np.isfinite(numbers_of(read_arm(path))).all()


@pytest.mark.parametrize(
    ("nominal", "said"),
    [
        ({"shape": "cone"}, "cone"),
        ({"shape": "plane", "point_mm": [0, 0, 0], "normal": [0, 0, 2]}, "unit length"),
        ({"shape": "plane", "point_mm": [0, 0], "normal": [0, 0, 1]}, "point_mm"),
        ({"shape": "sphere", "centre_mm": [0, 0, 0], "radius_mm": -1}, "radius_mm is -1"),
        ({}, "shape is missing"),
    ],
)
def test_a_spoilt_nominal_is_refused(tmp_path: Path, nominal: dict[str, Any], said: str) -> None:
    path = tmp_path / "n.json"
    path.write_text(json.dumps({"format": "crenel/nominal", "version": 1, **nominal}))
    with pytest.raises(OperationError, match=said):
        read_nominal(path)


def calibration_file() -> CalibrationFile:
    known = little_calibration()
    camera = known.camera
    return CalibrationFile.model_validate(
        {
            "camera": {
                "projection_matrix": camera.projection_matrix.tolist(),
                "matrix": camera.matrix.tolist(),
                "rotation": camera.rotation.tolist(),
                "translation_mm": camera.translation_mm.tolist(),
                "distortion": [-0.04, 0, 0, 0, 0],
                "width_px": camera.width_px,
                "height_px": camera.height_px,
            },
            "laser_plane": {"normal": [0.0, 0.0, 1.0], "offset_mm": 0.25},
            "probe_matrix": known.T_flange_sensor.tolist(),
            "serial_numbers": known.serial_numbers,
        }
    )


def test_a_calibration_reads_back(tmp_path: Path) -> None:
    path = tmp_path / "calibration.json"
    calibration_file().write(path)
    back, known = read_calibration(path), little_calibration()
    np.testing.assert_array_equal(back.camera.projection_matrix, known.camera.projection_matrix)
    np.testing.assert_array_equal(back.camera.distortion, [-0.04, 0, 0, 0, 0])
    np.testing.assert_array_equal(back.T_flange_sensor, known.T_flange_sensor)
    assert (back.plane.offset_mm, back.stripe_axis) == (0.25, "u")
    assert back.serial_numbers == known.serial_numbers


def test_documents_are_written_for_readers_too(tmp_path: Path) -> None:
    path = tmp_path / "object.json"
    odd = replace(BLOCK, name='[ 1, 2 ] [\n 3\n ] "4", -7e-05 [')
    write_object(path, odd)
    text = path.read_text()
    assert text.startswith('{\n "format": "crenel/object",\n "version": 1,\n')
    assert '"edges_x_mm": [-22.0, -14.0, -7.0, -2.0, 5.0, 10.0],\n' in text
    assert read_object(path) == odd


@pytest.mark.parametrize(
    ("spoil", "said"),
    [
        (lambda c: c["camera"]["projection_matrix"][0].__setitem__(3, 7.0), "projection_matrix"),
        (lambda c: c["camera"]["rotation"][0].__setitem__(0, 0.9), "rotation"),
        (lambda c: c["camera"].update(distortion=[0, 0, 0, 0]), "distortion"),
        (lambda c: c["camera"].update(distortion=[-5, 0, 0, 0, 0]), "not invertible"),
        (lambda c: c["camera"].pop("matrix"), "camera.matrix is missing"),
        (lambda c: c["laser_plane"].update(normal=[0, 0, 1.1]), "unit length"),
        (lambda c: c["probe_matrix"][3].__setitem__(0, 0.1), "last row"),
        (lambda c: c["probe_matrix"][0].__setitem__(0, 0.1), "probe_matrix"),
        (lambda c: c["probe_matrix"].pop(), "probe_matrix"),
        (lambda c: c.pop("laser_plane"), "no laser plane yet"),
    ],
)
def test_a_spoilt_calibration_is_refused(tmp_path: Path, spoil: Any, said: str) -> None:
    path = tmp_path / "calibration.json"
    calibration_file().write(path)
    edit_json(path, spoil)
    with pytest.raises(OperationError, match=said):
        read_calibration(path)


ENGLISH = "Standard uncertainty of a scanned point in the flange frame: 23 µm (k = 1); "
ENGLISH += "up to 50 µm is good."


def judged_file() -> CalibrationFile:
    text = message("point-known-good", total=quantity(23.1, "µm"), good=quantity(50.0, "µm"))
    finding = FindingPart(quality="good", code="uncertainty", text=text)
    verdict = VerdictPart(quality="good", text=text, findings=(finding,))
    poses = (PosePart(number=1, used=False, reason="left out manually"),)
    return calibration_file().model_copy(update={"verdict": verdict, "poses": poses})


def test_a_sentence_is_english_with_its_message_next_to_it(tmp_path: Path) -> None:
    path, judged = tmp_path / "calibration.json", judged_file()
    judged.write(path)
    verdict = json.loads(path.read_text())["verdict"]
    for part in (verdict, *verdict["findings"]):
        assert part["text"] == ENGLISH
        assert part["text_message"]["message_id"] == "point-known-good"
    assert "reason_message" not in json.loads(path.read_text())["poses"][0]
    assert CalibrationFile.read(path) == judged


def test_a_sentence_without_a_known_message_stays_english(tmp_path: Path) -> None:
    path = tmp_path / "calibration.json"
    judged_file().write(path)
    later = {"message_id": "later", "values": {}}
    edit_json(path, lambda fields: fields["verdict"].pop("text_message"))
    edit_json(path, lambda fields: fields["verdict"]["findings"][0].update(text_message=later))
    verdict = CalibrationFile.read(path).verdict
    assert verdict is not None
    assert verdict.text == ENGLISH
    assert verdict.findings[0].text == verdict.text


def test_a_list_of_sentences_has_a_list_of_messages() -> None:
    class Record(Document):
        FORMAT = "crenel/test"
        verdict: VerificationVerdict

    cut = message("file-cut-off")
    record = Record(verdict=VerificationVerdict(result="fail", text="No", reasons=("a", cut)))
    verdict = record.fields()["verdict"]
    assert verdict["reasons"] == ["a", "the file is incomplete"]
    assert verdict["reasons_message"] == ["a", {"message_id": "file-cut-off", "values": {}}]
    assert "text_message" not in verdict


COVARIANCE = {
    "parameters": ["fx", "link1_rx"],
    "matrix": [[4.0, 1e-6], [1e-6, 1e-10]],
    "pivot_mm": [0, 0, 100],
    "links": [2e-5],
}


def test_a_covariance_names_the_links_too(tmp_path: Path) -> None:
    path = tmp_path / "calibration.json"
    calibration_file().write(path)
    edit_json(path, lambda fields: fields.update(covariance=COVARIANCE))
    known = CalibrationFile.read(path).covariance
    assert known is not None
    assert known.links == (2e-5,)


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({"matrix": [[4.0, 0.0]]}, "with a row and a column for each of 2 parameters"),
        ({"matrix": [[4.0, 0.0], [0.0]]}, "with a row and a column"),
        ({"matrix": [[4.0, 1e-4], [0.0, 1e-10]]}, "must be symmetric"),
        ({"matrix": [[4.0, 0.0], [0.0, -1e-10]]}, "variances of at least 0"),
        ({"links": []}, "links must have one value"),
    ],
)
def test_a_covariance_that_cannot_be_is_refused(
    tmp_path: Path, change: dict[str, object], words: str
) -> None:
    path = tmp_path / "calibration.json"
    calibration_file().write(path)
    edit_json(path, lambda fields: fields.update(covariance=COVARIANCE | change))
    with pytest.raises(OperationError, match=words) as caught:
        CalibrationFile.read(path)
    assert "covariance" in str(caught.value)


@given(
    st.lists(st.floats(-3, 3), min_size=3, max_size=3), st.lists(lengths, min_size=3, max_size=3)
)
@settings(max_examples=30, suppress_health_check=[HealthCheck.function_scoped_fixture])
def test_any_probe_matrix_reads_back(tmp_path: Path, turn: list[float], move: list[float]) -> None:
    path = tmp_path / "calibration.json"
    calibration_file().write(path)
    T = rigid(rotation_from_vector(np.array(turn)), np.array(move))
    edit_json(path, lambda fields: fields.update(probe_matrix=T.tolist()))
    np.testing.assert_array_equal(read_calibration(path).T_flange_sensor, T)


def test_the_hash_of_a_file_that_was_extended_is_not_computed(tmp_path: Path) -> None:
    path = tmp_path / "scan.mcap"
    path.write_bytes(b"recorded")
    assert has_sha256(path, sha256(b"recorded").hexdigest())
    assert not has_sha256(path, "0" * 64)
    os.truncate(path, 1 << 42)
    assert not has_sha256(path, sha256(b"recorded").hexdigest())
    with pytest.raises(OperationError):
        has_sha256(tmp_path / "none", "0" * 64)
