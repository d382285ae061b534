"""The examples of ``docs/formats.md`` are read by the package's own readers."""

import importlib
import json
import pkgutil
import re
import tomllib
from pathlib import Path

import numpy as np
import pytest
import trustme
from google.protobuf.descriptor_pb2 import FieldDescriptorProto as Field
from google.protobuf.descriptor_pb2 import FileDescriptorSet
from scipy.spatial.transform import Rotation

import crenel.formats
from crenel.archive.manifest import Manifest
from crenel.formats.clouds.files import cloud_writer, read_cloud
from crenel.formats.csv_table import read_table
from crenel.formats.datasheets.arm import read_any_arm, read_arm
from crenel.formats.datasheets.sensor import read_sensor
from crenel.formats.datasheets.target import read_certificate, read_object
from crenel.formats.images import write_png
from crenel.formats.json_document import Document
from crenel.formats.recording.decoders import SCHEMAS
from crenel.formats.recording.reader import STATION_METADATA
from crenel.formats.recording.stripe_message import STRIPE_SCHEMA, stripe_descriptors
from crenel.formats.results.calibration import CalibrationFile, read_calibration
from crenel.formats.session.arm_session import read_observations
from crenel.formats.session.calibration_session import (
    BlockSession,
    BoardSession,
    read_any_session,
    write_contacts,
)
from crenel.formats.session.flange_columns import COLUMNS as POSE_COLUMNS
from crenel.formats.session.pose_pictures import ImageRow, write_images
from crenel.formats.session.scan_folder import read_scan_folder
from crenel.formats.settings.line_settings import SessionLine
from crenel.formats.settings.mask import Mask
from crenel.formats.settings.scan_settings import ScanSettings
from crenel.formats.settings.sync import Sync
from crenel.gauges.plan.document import read_plan, read_station_limits
from crenel.gauges.plan.document_gauge import read_gauge
from crenel.gauges.plan.document_length_standard import read_length_standard
from crenel.gauges.plan.document_temperatures import read_end_temperatures
from crenel.gauges.quick.clouds.document_nominal import read_nominal
from crenel.gauges.quick.maths.errors import NominalPlane, NominalSphere
from crenel.messages.message import Message
from crenel.metrology.arm.kinematics import Arm, RobotArm, flange_pose
from crenel.metrology.targets.chessboard import Chessboard, Markers
from crenel.rotations import CONVENTIONS
from crenel.settings.settings import Settings
from crenel.settings.station_toml import read_settings
from tests.present import present
from tests.sources import ROOT

PAGE = (ROOT / "docs/formats.md").read_text(encoding="utf-8")
EXAMPLE = re.compile(r"^```(?:json|csv|toml|xyz) (\S+)\n(.*?)^```$", re.MULTILINE | re.DOTALL)
DEFAULTS_SHOWN = ("limits", "verification", "decision", "due")
WITHOUT_DEFAULT = {"form_all", "range_all"}
"""Limits that are stated beside the tables of defaults."""


def block(kind: str) -> str:
    """The one fenced block of a kind that is no file."""
    (text,) = re.findall(rf"^```{kind}\n(.*?)^```$", PAGE, re.MULTILINE | re.DOTALL)
    return str(text)


def columns(path: Path) -> tuple[str, ...]:
    return read_table(path, ()).columns


def formats(kind: type[Document] = Document) -> set[str]:
    """``format`` of every document that the package defines."""
    own = {kind.FORMAT} if "FORMAT" in vars(kind) else set()
    return own.union(*(formats(below) for below in kind.__subclasses__()))


@pytest.fixture
def examples(tmp_path: Path) -> Path:
    """A folder with every example as a file."""
    for name, text in EXAMPLE.findall(PAGE):
        path = tmp_path / name
        path.parent.mkdir(parents=True, exist_ok=True)
        assert not path.exists(), name
        path.write_text(text, encoding="utf-8")
    for source, target in (("sensor.json", "board"), ("arm.json", "arm")):
        (tmp_path / target / source).write_bytes((tmp_path / "session" / source).read_bytes())
    return tmp_path


def with_pictures(folder: Path) -> Path:
    """The session's folder, with a black picture for each row of ``images.csv``."""
    sensor = read_sensor(folder / "sensor.json")
    picture = np.zeros((sensor.height_px, sensor.width_px), np.uint8)
    (folder / "images").mkdir()
    for row in read_table(folder / "images.csv", ("file",)).rows:
        write_png(folder / row.text("file"), picture)
    return folder


def test_the_session_is_read_and_written_alike(examples: Path) -> None:
    session = read_any_session(with_pictures(examples / "session"))
    assert isinstance(session, BlockSession)
    assert session.contacts.features == ("crest", "front")
    (pose,) = session.poses
    assert [path.name for path in pose.files] == ["pose00_ambient.png", "pose00_laser.png"]
    assert session.arm.joints[5].error.x_mm == 0.01
    assert read_certificate(examples / "session/object.json") == "DKD 4712, 2026-03"

    written = examples / "written.csv"
    write_contacts(written, session.contacts)
    assert columns(written) == columns(examples / "session/probing.csv")
    write_images(written, [ImageRow(0, "images/a.png", "both", pose.q_rad)])
    assert columns(written) == columns(examples / "session/images.csv")


def test_the_folders_of_scans_are_read(examples: Path) -> None:
    for name in ("scan", "timed"):
        for file, source in (("arm.json", "board"), ("sensor.json", "session")):
            (examples / name / file).write_bytes((examples / source / file).read_bytes())
    posed = read_scan_folder(examples / "scan")
    assert [one.file.name for one in posed.pictures] == ["0001.png", "0002.png"]
    assert posed.stamps_ns.tolist() == [one.stamp_ns for one in posed.pictures]
    assert posed.readings[:, 1].tolist() == [-80.25, -79.25]
    timed = read_scan_folder(examples / "timed")
    (picture,) = timed.pictures
    assert timed.stamps_ns[0] < picture.stamp_ns < timed.stamps_ns[1]


def test_the_rotations_of_robot_controllers_are_those_of_the_program() -> None:
    rows = re.findall(r"^\| [^|]+ \| `([a-z-]+)` \| `([^`]+)` \| `?([^`|]+)`? \|$", PAGE, re.M)
    shown = {name: (columns, what) for name, columns, what in rows}
    wanted = {
        name: (", ".join(one.columns), one.product or shown[name][1])
        for name, one in CONVENTIONS.items()
        if not name.startswith("euler-")
    }
    assert shown == wanted
    axes = ", ".join(name.removeprefix("euler-") for name in CONVENTIONS if "euler-" in name)
    assert f"the letters are the axes of the product: {axes} |" in PAGE
    assert f"`{CONVENTIONS['euler-ZYX'].product}`; the letters" in PAGE


def test_a_table_in_the_words_of_a_controller_is_read(examples: Path) -> None:
    (examples / "kuka/sensor.json").write_text((examples / "session/sensor.json").read_text())
    folder = read_scan_folder(examples / "kuka")
    turned = Rotation.from_euler("ZYX", [0, 90, -180], degrees=True).as_quat()
    assert abs(np.dot(folder.readings[0, 3:], turned)) == pytest.approx(1)


def test_the_robots_session_on_a_chessboard_is_read(examples: Path) -> None:
    session = read_any_session(with_pictures(examples / "board"))
    assert isinstance(session, BoardSession)
    assert isinstance(read_any_arm(examples / "board/arm.json"), RobotArm)
    assert isinstance(read_object(examples / "board/object.json"), Chessboard)
    marked = read_object(examples / "charuco/object.json")
    assert isinstance(marked, Chessboard)
    assert marked.markers == Markers("DICT_4X4_50", 7.5)
    (pose,) = session.poses
    assert present(pose.T_arm_flange)[:3, 3].tolist() == [612.5, -80.25, 433.0]
    assert columns(examples / "board/images.csv")[3:] == POSE_COLUMNS


def test_an_arm_of_five_joints_in_the_modified_convention_is_read(examples: Path) -> None:
    arm = read_arm(examples / "five/arm.json")
    assert arm.joint_count == 5
    # at zero: 25 + 260 + 20 along x, the last two lengths across
    T = flange_pose(arm, np.zeros(5))
    np.testing.assert_allclose(T[:3, 3], [305.0, 0.0, -25.0], atol=1e-9)


def test_the_arms_folder_is_read(examples: Path) -> None:
    arm = read_any_arm(examples / "arm/arm.json")
    assert isinstance(arm, Arm)
    found = read_observations(examples / "arm", arm)
    assert [seat.name for seat in found.seats] == ["cone 1"]
    assert [sphere.diameter_mm for sphere in found.spheres] == [25.4012]
    assert [bar.ends for bar in found.bars] == [("A", "B")]


def test_the_calibration_is_read_and_its_fields_are_named(examples: Path) -> None:
    calibration = read_calibration(examples / "calibration.json")
    assert calibration.serial_numbers.sensor == "S-9"
    section = PAGE.split("\n## Calibration\n")[1].split("\n## ")[0]
    for name in CalibrationFile.model_fields:
        assert f"`{name}`" in section or f'"{name}"' in section, name
    document = CalibrationFile.read(examples / "calibration.json")
    text = present(document.verdict).text
    assert isinstance(text, Message), "the example's message is none of the language files"
    assert str(text) == json.loads(document.text())["verdict"]["text"]
    assert f'"{text!s}"' in section


def test_gauges_and_nominals_are_read(examples: Path) -> None:
    assert isinstance(read_nominal(examples / "plate.nominal.json"), NominalPlane)
    assert isinstance(read_nominal(examples / "sphere.nominal.json"), NominalSphere)
    assert read_gauge(examples / "gauges/k-17.nominal.json").limits.radius_error == 40


def test_mask_delay_and_scan_settings_are_read(examples: Path) -> None:
    allowed = Mask.read(examples / "mask.json").where()
    assert not allowed[10, 10]
    assert allowed[500, 500]
    line = SessionLine.read(examples / "session/line.json").settings
    assert (line.stripe.max_width_px, line.channel) == (9, "red")
    assert Sync.read(examples / "sync.json").delay_ms == 3.42
    assert ScanSettings.read(examples / "scan_settings.json").choice == "strength"


def test_clouds_are_as_described(examples: Path) -> None:
    given, ply, xyz = (examples / name for name in ("cloud.xyz", "cloud.ply", "again.xyz"))
    cloud = read_cloud(given)
    assert cloud.intensity is not None
    assert cloud.uncertainty_um is not None
    assert cloud.frame is not None
    for path in (ply, xyz):
        with cloud_writer(path) as writer:
            writer.write(cloud.points_mm, cloud.intensity, cloud.uncertainty_um, cloud.frame)
    assert xyz.read_text() == given.read_text()
    header, end, _ = ply.read_bytes().partition(b"end_header\n")
    assert (header + end).decode() == block("ply")


def test_the_recordings_topics_and_message_are_as_described() -> None:
    for topic, kinds in SCHEMAS.items():
        (row,) = (line for line in PAGE.splitlines() if line.startswith(f"| `{topic}` |"))
        assert all(f"`{kind}`" in row for kind in kinds), topic
    assert f"`{STATION_METADATA}`" in PAGE
    (message,) = FileDescriptorSet.FromString(stripe_descriptors()).file[1].message_type
    assert f"crenel.{message.name}" == STRIPE_SCHEMA
    assert re.findall(r"^  (repeated )?([\w.]+) (\w+) = (\d+);", block("proto"), re.MULTILINE) == [
        (
            "repeated " if field.label == Field.LABEL_REPEATED else "",
            field.type_name.lstrip(".") or Field.Type.Name(field.type)[5:].lower(),
            field.name,
            str(field.number),
        )
        for field in message.field
    ]


def test_station_toml_has_every_key_and_the_defaults(examples: Path) -> None:
    file = examples / "station.toml"
    for name in ("cert.pem", "key.pem", "mqtt-password", "archive-secret", "client-secret"):
        (examples / name).touch()
    trustme.CA().cert_pem.write_to_path(str(examples / "ca.pem"))
    settings, written = read_settings(file), tomllib.loads(file.read_text(encoding="utf-8"))
    for name in set(Settings.model_fields) - {"sensors"}:  # instead of the table of one
        keys = set(type(getattr(settings, name)).model_fields) - WITHOUT_DEFAULT
        assert set(written[name]) >= keys, name
    assert all(f"`{key}`" in PAGE for key in WITHOUT_DEFAULT)
    for name in DEFAULTS_SHOWN:
        table = getattr(settings, name)
        assert table == type(table)(), name


def test_every_document_of_the_package_is_named() -> None:
    for module in pkgutil.walk_packages(crenel.formats.__path__, "crenel.formats."):
        importlib.import_module(module.name)
    assert "crenel/tip-check" in formats()
    missing = {name for name in formats() if f"`{name}`" not in PAGE and f'"{name}"' not in PAGE}
    assert not missing


def test_limits_of_a_performance_test_are_read(examples: Path) -> None:
    limits = [(one.quantity, one.a_um) for one in read_station_limits(examples)]
    assert limits == [("form-touch", 25), ("location-scan", 60)]


def test_a_length_standard_and_a_plan_of_a_performance_test_are_read(examples: Path) -> None:
    bar = read_length_standard(examples / "gauges/bar.json")
    assert bar.lengths[0].length_mm == 400.0123
    plan = read_plan(examples / "performance")
    assert read_end_temperatures(examples / "performance").arm_c == 21.4
    assert present(plan.sphere).diameter_mm == 24.9987
    limit = present(plan.limit("length-touch"))
    assert limit.at(1000.0) == 60.0


def test_a_manifest_of_the_archive_is_read(examples: Path) -> None:
    file = examples / "archived/manifest.json"
    manifest = Manifest.parse(file.read_bytes(), file.name)
    assert manifest.folder == f"scans/20260504-101500/{manifest.content}"
