"""What a calibration says of itself, beside its figure."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from crenel.errors import OperationError
from crenel.metrology.calibration.findings import (
    CalibrationFinding,
    Quality,
    contact_findings,
    size_coverage_findings,
    size_finding,
    sort_by_severity,
)
from crenel.metrology.calibration.one_pose import OnePoseInputs, calibrate_one_pose
from crenel.metrology.detection.detect_block import ObjectDetection
from crenel.metrology.limits import Limits
from crenel.metrology.probing.alignment import align
from tests.metrology.builders import BLOCK, TIP_RADIUS_MM, contacts_on, random_pose
from tests.metrology.seen_block import camera_over
from tests.metrology.test_one_pose import read_inputs

pytestmark = pytest.mark.slow


@pytest.mark.parametrize(
    ("faces", "error_mm", "quality", "said"),
    [
        (("crest", "front", "left"), 0.1, "neutral", "unchecked"),
        (("crest", "front", "back", "left"), 0.0, "good", "front and back"),
        (("crest", "front", "left", "right"), 0.05, "attention", "closer together"),
        (("crest", "front", "back", "left", "right"), -0.05, "attention", "further apart"),
    ],
)
def test_opposite_faces_show_the_tips_diameter(
    faces: tuple[str, ...], error_mm: float, quality: str, said: str
) -> None:
    rng = np.random.default_rng(21)
    features, tips = contacts_on(rng, random_pose(rng), faces=faces, noise_mm=0.005)
    found = size_finding(align(features, tips, TIP_RADIUS_MM + error_mm, BLOCK), features, BLOCK)
    assert found.quality == quality
    assert said in str(found.text)


def test_the_gravest_finding_comes_first_and_the_others_as_they_were() -> None:
    qualities: tuple[Quality, ...] = ("good", "attention", "neutral", "bad", "attention")
    found = [CalibrationFinding(quality, f"code-{i}", "") for i, quality in enumerate(qualities)]
    assert [one.code for one in sort_by_severity(found)] == [f"code-{i}" for i in (3, 1, 4, 0, 2)]


@pytest.mark.parametrize(("noise_mm", "quality"), [(0.01, "good"), (0.08, "attention")])
def test_contacts_that_scatter_widely_are_never_good(noise_mm: float, quality: str) -> None:
    features, tips = contacts_on(np.random.default_rng(4), np.eye(4), noise_mm=noise_mm)
    (said, *_) = contact_findings(align(features, tips, TIP_RADIUS_MM, BLOCK), features)
    assert (said.code, said.quality) == ("contacts", quality)
    wide = Limits(good_um=200.0)
    (said, *_) = contact_findings(align(features, tips, TIP_RADIUS_MM, BLOCK), features, wide)
    assert said.quality == "good"


@pytest.fixture(scope="module")
def inputs(samples: Path) -> OnePoseInputs:
    return read_inputs(samples / "one-pose")


def said_of(inputs: OnePoseInputs) -> dict[str, str]:
    return {found.code: found.quality for found in calibrate_one_pose(inputs).findings}


def test_what_one_pose_cannot_show_is_said(inputs: OnePoseInputs) -> None:
    said = said_of(inputs)
    assert said["arm-unseen"] == said["size-unchecked"] == "neutral"
    assert set(said.values()) == {"neutral", "good"}


def test_a_certificate_wrong_along_the_view_is_found_by_its_pixels(inputs: OnePoseInputs) -> None:
    block = replace(inputs.block, front_y_mm=inputs.block.front_y_mm + 0.06)
    assert said_of(replace(inputs, block=block))["pixels-oblong"] == "attention"


def test_one_that_is_further_wrong_is_refused(inputs: OnePoseInputs) -> None:
    block = replace(inputs.block, front_y_mm=inputs.block.front_y_mm + 0.2)
    with pytest.raises(OperationError, match="does not match the certificate"):
        said_of(replace(inputs, block=block))


def test_the_joints_of_quite_another_pose_are_reported(inputs: OnePoseInputs) -> None:
    q_rad = inputs.pose_q_rad.copy()
    q_rad[0] += np.pi
    assert said_of(replace(inputs, pose_q_rad=q_rad))["sensor-far"] == "attention"


def test_a_size_that_no_picture_shows_is_said() -> None:
    def seen(*unseen: tuple[int, int]) -> ObjectDetection:
        return ObjectDetection((), (), camera_over(BLOCK), 0.1, unseen)

    [said] = size_coverage_findings([seen((0, 2), (1, 1))])
    assert said.code == "size-unseen"
    assert "merlon 2" in str(said.text)
    assert "back" in str(said.text)
    [said] = size_coverage_findings([seen((0, 2)), seen((0, 2))])
    assert "merlon 2" in str(said.text)
    assert size_coverage_findings([seen((0, 2)), seen()]) == []
