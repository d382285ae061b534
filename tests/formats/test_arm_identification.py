"""Folders for an arm's identification, as files: read, identified, written, and refused."""

import json
import shutil
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

from crenel.errors import OperationError
from crenel.formats.datasheets.arm import ArmFile, read_arm
from crenel.formats.json_document import file_sha256
from crenel.formats.session.arm_session import read_identification_session
from crenel.metrology.arm.identification.articulation import ArticulationLimits
from crenel.workflows.check_articulation import check_table, report_rows, worst_verdict
from crenel.workflows.identify_arm import identify_folder
from tests.metrology.arm_sessions import collect_observations, volumetric_error_um
from tests.refusals import refused_as
from tests.simulated_arm_sessions import ArmSessionPlan, SimulatedArmSession, render_arm_session

pytestmark = pytest.mark.slow

PLAN = ArmSessionPlan(
    seats=6,
    points_per_seat=14,
    spheres=2,
    points_per_sphere=14,
    bar_lengths_mm=(600.0,),
    positions_per_bar=4,
    points_per_end=3,
)


Rendered = tuple[Path, SimulatedArmSession]


@pytest.fixture(scope="module")
def rendered(tmp_path_factory: pytest.TempPathFactory) -> Rendered:
    folder = tmp_path_factory.mktemp("rendered") / "s"
    return folder, render_arm_session(folder, 3, PLAN)


@pytest.fixture
def folder(rendered: Rendered, tmp_path: Path) -> Path:
    return Path(shutil.copytree(rendered[0], tmp_path / "s"))


def test_what_is_read_is_what_was_touched(folder: Path, rendered: Rendered) -> None:
    read = read_identification_session(folder)
    expected = collect_observations(rendered[1])
    assert [seat.name for seat in read.observations.seats] == [s.name for s in expected.seats]
    for mine, theirs in zip(read.observations.bars, expected.bars, strict=True):
        assert (mine.name, mine.position, mine.length_mm) == ("B1", theirs.position, 600.0)
        np.testing.assert_allclose(mine.q_rad[1], theirs.q_rad[1], atol=1e-12)
    assert read.observations.spheres[1].diameter_mm == 25.0
    assert len(read.files) == 4


def test_the_identified_arm_is_written_with_its_covariance_for_others_too(
    folder: Path, rendered: Rendered, tmp_path: Path
) -> None:
    out = tmp_path / "identified.json"
    document, result = identify_folder(folder, out)
    assert ArmFile.read(out) == document
    fields = json.loads(out.read_text())
    assert fields["format"] == "crenel/arm"
    assert {"parameters", "covariance", "created_at", "inputs", "software", "validation"} <= set(
        fields["identification"]
    )
    true_arm = rendered[1].arm
    before = volumetric_error_um(true_arm, read_arm(folder / "arm.json"))
    assert volumetric_error_um(true_arm, read_arm(out)) < before / 10
    part = document.identification
    assert part is not None
    count = len(part.parameters)
    covariance = np.array(part.covariance)
    assert covariance.shape == (count, count)
    sds = [parameter.standard_uncertainty for parameter in part.parameters]
    np.testing.assert_allclose(np.sqrt(np.diag(covariance)), sds, rtol=1e-9)
    angle = next(p for p in part.parameters if p.name == "J2.theta_deg")
    joint = next(joint for joint in document.joints if joint.name == "J2")
    assert angle.after == pytest.approx(joint.theta_deg, abs=1e-12)
    hashes = {one.file: one.sha256 for one in part.inputs}
    assert hashes["spheres.csv"] == file_sha256(folder / "spheres.csv")
    assert part.validation.after.normalised < part.validation.before.normalised / 5
    assert len(result.changes) == count


def test_a_separate_folder_checks_the_result(folder: Path, tmp_path: Path) -> None:
    check = tmp_path / "check"
    check.mkdir()
    lines = (folder / "articulation.csv").read_text().splitlines()
    for path, sets in ((check, ("S5", "S6")), (folder, ("S1", "S2", "S3", "S4"))):
        kept = [line for line in lines[1:] if line.startswith(sets)]
        (path / "articulation.csv").write_text("\n".join([lines[0], *kept]) + "\n")
    document, _ = identify_folder(folder, tmp_path / "out.json", check)
    assert document.identification is not None
    assert document.identification.validation.method == "separate"
    assert document.identification.validation.places == 2


def test_the_result_never_replaces_what_it_is_made_from(folder: Path, tmp_path: Path) -> None:
    before = (folder / "arm.json").read_bytes()
    with pytest.raises(OperationError, match="computed from"):
        identify_folder(folder, folder / "arm.json")
    assert (folder / "arm.json").read_bytes() == before


Edit = Callable[[list[str]], list[str]]


def edited(folder: Path, table: str, edit: Edit) -> None:
    path = folder / table
    path.write_text("\n".join(edit(path.read_text().splitlines())) + "\n")


def radians(lines: list[str]) -> list[str]:
    def turn(line: str) -> str:
        name, *angles = line.split(",")
        return ",".join([name, *(str(float(q) / 57.29578) for q in angles)])

    return [lines[0], *map(turn, lines[1:])]


def replaced(old: str, new: str, rows: slice = slice(None)) -> Edit:
    """The first of these texts in each of these lines becomes another one."""

    def edit(lines: list[str]) -> list[str]:
        lines[rows] = [line.replace(old, new, 1) for line in lines[rows]]
        return lines

    return edit


@pytest.mark.parametrize(
    ("table", "edit", "code"),
    [
        ("articulation.csv", radians, "joints-in-radians"),
        ("articulation.csv", lambda x: [c.rsplit(",", 1)[0] for c in x], "joint-count"),
        ("articulation.csv", lambda x: [x[0], *x[1:4]], "too-few-points"),
        ("articulation.csv", lambda x: [x[0], *([x[1]] * 20), *x[15:]], "arm-hardly-moved"),
        ("articulation.csv", lambda x: x[:1], "no-points"),
        ("articulation.csv", lambda x: [x[0], x[1][x[1].index(",") :]], "cell-empty"),
        ("spheres.csv", replaced("25.0", "24.0", slice(3, 4)), "length-differs"),
        ("spheres.csv", replaced("25.0", "26.0"), "tip-diameter"),
        ("spheres.csv", replaced("25.0", "-25"), "length-not-positive"),
        ("ballbars.csv", lambda x: [c for c in x if ",B," not in c], "bar-ends"),
        ("ballbars.csv", replaced("0.002", "3"), "uncertainty-senseless"),
        ("ballbars.csv", replaced("length_mm", "length"), "columns-missing"),
    ],
)
def test_bad_tables_are_refused(
    folder: Path, tmp_path: Path, table: str, edit: Edit, code: str
) -> None:
    edited(folder, table, edit)
    with refused_as(code, where="s"):
        identify_folder(folder, tmp_path / "out.json")
    assert not (tmp_path / "out.json").exists()


def test_a_folder_without_tables_is_refused(folder: Path, tmp_path: Path) -> None:
    for name in ("articulation.csv", "spheres.csv", "ballbars.csv"):
        (folder / name).unlink()
    with refused_as("no-observations"):
        identify_folder(folder, tmp_path / "out.json")


def test_the_check_reports_half_range_and_two_sigma(folder: Path, tmp_path: Path) -> None:
    by_prior = check_table(folder, None, ArticulationLimits(half_range_um=60.0))
    assert worst_verdict(by_prior) == "fail"
    identify_folder(folder, tmp_path / "out.json")
    table = folder / "articulation.csv"
    limits = ArticulationLimits(half_range_um=60.0, two_sigma_um=60.0)
    identified = check_table(table, tmp_path / "out.json", limits)
    assert worst_verdict(identified) == "pass"
    assert len(report_rows(identified)) == 6
    for report in identified:
        check = report.check
        assert check.points == 14
        assert np.all(check.two_sigma_um < 3 * check.encoders_two_sigma_um + 10)
        assert np.all(check.half_range_um < 2 * check.two_sigma_um)
