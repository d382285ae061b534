"""Inspections from the files to results: uncertainties, decisions, and what is named."""

import json
import shutil
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from typer.testing import CliRunner

from crenel.cli.main import cli
from crenel.parts.document_results import InspectionFile
from crenel.parts.evaluate import inspect_part
from crenel.parts.evaluate_folder import find_files
from tests.parts.draws import first_setting, write_draw

pytestmark = pytest.mark.slow

Change = Callable[[dict[str, Any]], None]


@pytest.fixture(scope="module")
def drawn(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """An inspection folder with a scan and touches of the datums."""
    folder = tmp_path_factory.mktemp("drawn")
    write_draw(folder, first_setting(), 3)
    return folder


@pytest.fixture
def folder(drawn: Path, tmp_path: Path) -> Path:
    """A copy, to be changed."""
    return Path(shutil.copytree(drawn, tmp_path / "part"))


@pytest.fixture(scope="module")
def usual(drawn: Path) -> InspectionFile:
    return inspect_part(find_files(drawn))


def change(path: Path, how: Change) -> None:
    document = json.loads(path.read_text())
    how(document)
    path.write_text(json.dumps(document))


def u_of(result: InspectionFile, name: str) -> float:
    found = next(one for one in result.dimensions if one.id == name)
    assert found.standard_uncertainty is not None
    return found.standard_uncertainty


def test_contributions_add_up_and_correlation_is_one(usual: InspectionFile) -> None:
    for one in usual.dimensions:
        total = np.sqrt(sum(value**2 for value in one.contributions.values()))
        assert total == pytest.approx(one.standard_uncertainty, rel=1e-6)
    assert usual.correlation is not None
    found = np.array(usual.correlation)
    assert np.allclose(found, found.T)
    assert np.linalg.eigvalsh(found).min() > -1e-6


def test_what_features_share_cancels(folder: Path, usual: InspectionFile) -> None:
    """A step between two planes of one scan is known better than either plane."""

    def keep_diagonal(document: dict[str, Any]) -> None:
        matrix = np.array(document["covariance"]["matrix"])
        document["covariance"]["matrix"] = np.diag(np.diag(matrix)).tolist()

    assert usual.alignment is not None
    plane = next(one for one in usual.features if one.id == "S")
    assert plane.covariance is not None
    alone_um = 1e3 * float(np.sqrt(plane.covariance[-1][-1]))
    assert 1e3 * u_of(usual, "step") < alone_um / 4
    change(folder / "calibration.json", keep_diagonal)
    diagonal = inspect_part(find_files(folder))
    ratio = np.array([u_of(diagonal, one.id) / u_of(usual, one.id) for one in usual.dimensions])
    assert np.abs(np.log(ratio)).max() > np.log(1.3)


def test_true_values_are_within_what_is_claimed(usual: InspectionFile) -> None:
    from tests.parts.bracket_program import bracket_dimensions

    setting = first_setting()
    true = {one["id"]: value for one, value in bracket_dimensions(setting.nominal, setting.true)}
    for one in usual.dimensions:
        assert one.standard_uncertainty is not None
        if one.kind != "position":
            assert abs(one.value - true[one.id]) < 4 * one.standard_uncertainty, one.id


def test_an_old_calibration_is_used_with_a_note(folder: Path, usual: InspectionFile) -> None:
    def drop_links(document: dict[str, Any]) -> None:
        known = document["covariance"]
        known["parameters"] = known["parameters"][:23]
        known["matrix"] = [row[:23] for row in known["matrix"][:23]]
        del known["links"]

    change(folder / "calibration.json", drop_links)
    old = inspect_part(find_files(folder))
    assert old.correlation_unknown
    assert any("correlation is unknown" in str(text) for text in old.warnings)
    assert old.uncertainty == "full"
    pooled = np.mean([u_of(old, one.id) ** 2 for one in usual.dimensions])
    assert pooled > np.mean([u_of(usual, one.id) ** 2 for one in usual.dimensions])


@pytest.mark.parametrize("what", ["covariance", "encoders"])
def test_without_uncertainties_nothing_is_decided(folder: Path, what: str) -> None:
    def forget_noise(document: dict[str, Any]) -> None:
        for joint in document["joints"]:
            joint["encoder_sd_deg"] = 0.0

    def forget_scales(document: dict[str, Any]) -> None:
        del document["scales"]

    def forget_covariance(document: dict[str, Any]) -> None:
        del document["covariance"]

    if what == "covariance":
        change(folder / "calibration.json", forget_covariance)
    else:
        change(folder / "arm.json", forget_noise)
        change(folder / "calibration.json", forget_scales)
    result = inspect_part(find_files(folder))
    assert result.uncertainty == "scatter"
    assert result.correlation is None
    for one in result.dimensions:
        assert one.standard_uncertainty is None
        assert one.scatter is not None
        assert one.decision == "undecided"


def test_datums_by_touch_name_bad_touches(folder: Path) -> None:
    change(folder / "program.json", lambda one: one["alignment"].update(by="touch"))
    rows = (folder / "touches.csv").read_text().splitlines()
    first_of_b = next(k for k, row in enumerate(rows) if row.startswith("B,"))
    wrong = rows[1].replace("A,", "B,")
    rows.insert(first_of_b + 1, wrong)
    (folder / "touches.csv").write_text("\n".join(rows) + "\n")
    result = inspect_part(find_files(folder))
    named = [str(text) for text in result.warnings if f"line {first_of_b + 2}" in str(text)]
    assert len(named) == 1
    assert "lies on A" in named[0]
    datum = next(one for one in result.features if one.id == "B" and one.source == "touch")
    assert [(one.rule, one.count) for one in datum.excluded] == [("other-feature", 1)]


def test_the_command_ends_with_the_verdict(folder: Path) -> None:
    run = CliRunner().invoke(cli, ["inspect", str(folder), "--json"])
    assert run.exit_code == 4
    written = json.loads((folder / "results.json").read_text())
    assert {one["decision"] for one in written["dimensions"]} >= {"pass", "fail"}
    keep_only(folder, "d-ball")
    loosen(folder, 1.0)
    assert CliRunner().invoke(cli, ["inspect", str(folder)]).exit_code == 0
    loosen(folder, 0.001)
    assert CliRunner().invoke(cli, ["inspect", str(folder)]).exit_code in (4, 5)


def keep_only(folder: Path, name: str) -> None:
    def drop(document: dict[str, Any]) -> None:
        document["dimensions"] = [one for one in document["dimensions"] if one["id"] == name]

    change(folder / "program.json", drop)


def loosen(folder: Path, mm: float) -> None:
    def limit(document: dict[str, Any]) -> None:
        document["dimensions"][0].update(lower=-mm, upper=mm)

    change(folder / "program.json", limit)


def test_the_frame_alone_says_where_it_is_known(folder: Path) -> None:
    run = CliRunner().invoke(cli, ["align", str(folder)])
    assert run.exit_code == 0, run.output
    written = json.loads((folder / "alignment.json").read_text())
    known = [one["u_um"] for one in written["alignment"]["known_at"]]
    assert len(known) == 11
    assert max(known) > min(known) > 1
    assert np.allclose(np.array(written["alignment"]["T_arm_part"])[3], [0, 0, 0, 1])


def test_flatness_below_the_noise_is_not_decided(folder: Path) -> None:
    def add(document: dict[str, Any]) -> None:
        document["dimensions"] = [
            {"id": name, "kind": "flatness", "features": ["S"], "nominal": 0, "upper": upper}
            for name, upper in (("fine", 0.001), ("coarse", 0.5))
        ]

    change(folder / "program.json", add)
    result = inspect_part(find_files(folder))
    fine, coarse = result.dimensions
    assert (fine.decision, coarse.decision) == ("undecided", "pass")
    assert fine.by_chance is not None
    assert fine.value == pytest.approx(fine.by_chance, rel=0.25)
    assert any("cannot be decided" in str(text) for text in result.warnings)
