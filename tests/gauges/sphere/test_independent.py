"""The figures of scanned spheres and plates against an independent computation from the same
files."""

import ast
from pathlib import Path

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from crenel.formats.recording.writer import RecordingWriter
from crenel.gauges.kinds import write_performance
from crenel.gauges.plan.document import PLAN, PerformancePlan, PlatePart, plane_scan
from crenel.metrology.transforms import inverse, rigid
from tests.bench.metrology.rendered_sphere import RenderedStation
from tests.bench.metrology.synthetic_arm import JointArm
from tests.bench.metrology.synthetic_sphere import (
    CENTRE,
    FRAME_NS,
    HEIGHT,
    T_FLANGE_SENSOR,
    WIDTH,
    Faults,
    PlantedFaults,
    scan_orientation,
    stripe_of_points,
    true_camera,
    write_calibration,
)
from tests.gauges.sphere import independent_figures
from tests.gauges.sphere.independent_figures import independent_figures_um, independent_plane_um
from tests.present import present

pytestmark = pytest.mark.slow

WITHIN_UM = 0.1
NOISE = Faults(point_sd_mm=0.02, outliers=0.02)


@pytest.fixture(scope="module")
def station() -> RenderedStation:
    return RenderedStation(width_px=640, height_px=512, frames=40, seed=3)


@pytest.mark.parametrize(
    "faults",
    [
        PlantedFaults(),
        PlantedFaults(matrix_offset_mm=(0.03, -0.05, 0.02), outliers=0.03, link_mm=0.05),
    ],
    ids=["as it should be", "with faults"],
)
def test_figures_agree(station: RenderedStation, tmp_path: Path, faults: PlantedFaults) -> None:
    folder = station.write(tmp_path / "test", faults)
    result = write_performance(folder)
    values = {one.quantity: one.value for one in result.figures}
    independent_um = independent_figures_um(folder)
    assert set(values) == set(independent_um)
    assert None not in values.values()
    assert values == pytest.approx(independent_um, abs=WITHIN_UM)


def write_plane_test(folder: Path) -> Path:
    """A plate that is scanned in two orientations, with noise and outliers."""
    folder.mkdir()
    arm, camera = JointArm(), true_camera()
    plate = PlatePart(name="Granite", flatness_um=3.0, flatness_sd_um=0.5)
    begun = "2026-11-26T10:00:00+00:00"
    PerformancePlan(id="t", kind="plane", started_at=begun, plate=plate).write(folder / PLAN)
    arm.write(folder / "arm.json")
    write_calibration(folder / "calibration.json")
    random = np.random.default_rng(4)
    outward = camera.centre_mm / np.linalg.norm(camera.centre_mm)
    across = np.arange(-30.0, 30.0, 0.1)
    line = np.column_stack([across, np.zeros((len(across), 2))])
    normals = np.tile(outward, (len(line), 1))
    for number, turn_deg in enumerate((45.0, 135.0), 1):
        turn = Rotation.from_euler("z", turn_deg, degrees=True)
        R = turn.as_matrix() @ scan_orientation(1)
        along = np.cross(R @ outward, R[:, 0])
        (folder / plane_scan(number)).mkdir()
        path = folder / plane_scan(number) / "scan.mcap"
        with RecordingWriter(path, arm.joint_names) as writer:
            for i, step in enumerate(np.arange(-30.0, 30.0, 1.0)):
                stamp_ns = 10**9 + i * FRAME_NS
                q = present(arm.reading(rigid(R, CENTRE + step * along) @ inverse(T_FLANGE_SENSOR)))
                for ms in (-4, 4):
                    writer.reading(stamp_ns + ms * 10**6, q)
                stripe = present(stripe_of_points(camera, line, normals, NOISE, random))
                writer.stripe(stamp_ns, stripe, WIDTH, HEIGHT)
    return folder


def test_the_form_of_a_plate_agrees(tmp_path: Path) -> None:
    folder = write_plane_test(tmp_path / "test")
    (figure,) = write_performance(folder).figures
    independent_um = independent_plane_um(folder)
    assert figure.value == pytest.approx(max(independent_um), abs=WITHIN_UM)
    assert list(figure.values) == pytest.approx(independent_um, abs=WITHIN_UM)
    assert 10 < max(independent_um) < 60


def test_the_computation_uses_nothing_of_the_evaluation() -> None:
    tree = ast.parse(Path(independent_figures.__file__).read_text())
    imported = [node.module or "" for node in ast.walk(tree) if isinstance(node, ast.ImportFrom)]
    ours = ("crenel.metrology", "crenel.workflows", "crenel.gauges")
    assert not [name for name in imported if name.startswith(ours)]
