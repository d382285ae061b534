"""The one-sphere test on touches and recordings with planted faults."""

import shutil
from collections.abc import Callable
from datetime import UTC, datetime
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from crenel.errors import OperationError
from crenel.formats.recording.reader import EXTRACTION, SCAN_STARTED
from crenel.formats.recording.writer import RecordingWriter
from crenel.gauges.exchange.export import export_result
from crenel.gauges.exchange.write_certificate import Issuer
from crenel.gauges.judgement.document import PerformanceFile, read_performance
from crenel.gauges.judgement.evaluate_measured_data import last_measured_at
from crenel.gauges.kinds import evaluate_performance, write_performance
from crenel.gauges.plan.document import PLAN, RESULT, TOUCHES, LimitPart, read_plan, sphere_scan
from crenel.gauges.plan.document_symbols import Quantity
from crenel.messages.message import Message, message
from crenel.timestamps import parse_moment
from tests.bench.metrology import synthetic_sphere
from tests.bench.metrology.synthetic_sphere import SPHERE, Faults, SphereSession
from tests.gauges.contact.test_contacts import figures_of, planned
from tests.present import present
from tests.running.usual import usual

pytestmark = pytest.mark.slow

QUIET: dict[str, Any] = {"touch_sd_mm": 0.003, "point_sd_mm": 0.008}


def with_faults(folder: Path, **faults: Any) -> Path:
    """The folder of a test with these faults."""
    return SphereSession(folder, Faults(**faults)).write()


@pytest.fixture(scope="module")
def perfect(tmp_path_factory: pytest.TempPathFactory) -> PerformanceFile:
    """What a test without faults gives."""
    return evaluated(tmp_path_factory.mktemp("perfect") / "t")


@pytest.fixture(scope="module")
def quiet(tmp_path_factory: pytest.TempPathFactory) -> PerformanceFile:
    """What a test with little noise gives."""
    return evaluated(tmp_path_factory.mktemp("quiet") / "t", **QUIET)


def values(result: PerformanceFile) -> dict[str, float | None]:
    return {figure.quantity: figure.value for figure in result.figures}


def known(result: PerformanceFile) -> dict[str, float]:
    """The values of figures that have one."""
    return {name: value for name, value in values(result).items() if value is not None}


def limits_um(of: dict[Quantity, float]) -> tuple[LimitPart, ...]:
    return tuple(LimitPart(quantity=name, a_um=a_um) for name, a_um in of.items())


def problem(result: PerformanceFile, quantity: Quantity) -> str:
    return str(figures_of(result)[quantity].problem)


def evaluated(folder: Path, **faults: Any) -> PerformanceFile:
    """Of a test with these faults."""
    return evaluate_performance(with_faults(folder, **faults))


def test_a_perfect_station_has_no_errors(perfect: PerformanceFile) -> None:
    result, found = perfect, values(perfect)
    assert len(found) == 11
    assert all(value is not None and abs(value) < 1e-3 for value in found.values()), found
    assert result.spheres[0].moved_um == pytest.approx(0, abs=1e-6)
    by_scan = [patch.deviation_um for patch in result.spheres[0].patches]
    for deviations in (result.spheres[0].touch_deviations_um, by_scan):
        assert len(deviations) == 25
        assert all(off is not None and abs(off) < 0.01 for off in deviations)
    assert not present(result.offset).significant
    # and articulations that were held as wanted are not mentioned
    assert not [note for note in result.notes if "articulation" in str(note)]
    assert len(result.spheres[0].stylus_directions) == 5
    assert len(result.spheres[0].view_directions) == 5
    assert "no conformity" in str(result.status)
    assert {one.file for one in result.inputs} >= {PLAN, TOUCHES, f"{sphere_scan(1, 5)}/scan.mcap"}


def test_noise_shows_as_the_standards_let_expect(quiet: PerformanceFile) -> None:
    found = known(quiet)
    # noise lies in the plane of the light, and counts along the sphere's normal
    assert 0.7 < found["dispersion-scan"] / (3.92 * 8) < 1
    assert found["form-touch"] == pytest.approx(3.66 * 3, rel=0.5)
    assert found["form-scan"] < 4  # hundreds of points a patch
    assert found["location-scan"] < 8


@pytest.mark.parametrize("axis", usual([1, 0, 2], 1, pytest.mark.soak))
def test_a_wrong_probe_matrix_is_named_with_its_direction(tmp_path: Path, axis: int) -> None:
    offset = tuple(0.05 * np.eye(3)[axis])
    result = evaluated(tmp_path / "t", matrix_offset_mm=offset, **QUIET)
    # 1.5 to 1.7 times the offset for articulations tilted by 40°
    assert 70 < known(result)["location-scan"] < 90
    assert result.offset is not None
    np.testing.assert_allclose(result.offset.offset_mm, offset, atol=0.004)
    assert result.offset.significant
    assert result.offset.left_um < 8
    assert "Calibrating again would help" in str(result.offset.text)
    assert abs(known(result)["size-touch"]) < 8


def test_a_wrong_scale_shows_in_the_size(tmp_path: Path) -> None:
    """In the plane of the light, not along the arm's motion: half of 25 µm."""
    found = values(evaluated(tmp_path / "t", scale=1.001))
    assert found["size-all-scan"] == pytest.approx(13, abs=3)
    assert found["size-touch"] == pytest.approx(0, abs=0.01)


def test_a_worn_tip_shows_in_the_touched_size_alone(tmp_path: Path) -> None:
    result = evaluated(tmp_path / "t", tip_excess_mm=-0.02)
    found = values(result)
    assert found["size-touch"] == pytest.approx(-20, abs=0.01)
    for quantity in ("form-touch", "location-touch", "size-scan", "location-scan"):
        assert found[quantity] == pytest.approx(0, abs=0.01), quantity
    assert not result.problems


def test_outliers_show_in_form_and_dispersion(quiet: PerformanceFile, tmp_path: Path) -> None:
    clean, spoilt = known(quiet), known(evaluated(tmp_path / "b", outliers=0.04, **QUIET))
    for quantity in ("form-scan", "dispersion-scan"):
        assert spoilt[quantity] > clean[quantity] + 1, quantity


def test_a_sphere_that_moved_has_no_symbols(tmp_path: Path) -> None:
    result = evaluated(tmp_path / "t", moved_mm=(0.1, 0.0, 0.0), **QUIET)
    assert result.spheres[0].moved_um == pytest.approx(100, abs=10)
    assert set(values(result).values()) == {None}
    assert "moved by" in str(result.problems[0])
    assert result.verdict.result == "uncertain"
    # nor by another name: the offset and the second figures follow from the same centres
    assert result.offset is None
    sphere = result.spheres[0]
    assert sphere.location_fixed_um is sphere.free_dispersion_um is None
    assert sphere.scan_centres_mm


@pytest.mark.parametrize(
    ("changes", "words"),
    [
        ({"serial_number": "B-1"}, "the object that the sensor was calibrated with"),
        ({"serial_number": " b -1"}, "the object that the sensor was calibrated with"),
        ({"diameter_mm": 8.0}, "10 mm or more"),
        ({"valid_until": "2025-12-31"}, "valid until 2025-12-31"),
        ({"valid_until": "soon"}, "is no date"),
        ({"diameter_sd_um": 0.0}, "no uncertainty"),
    ],
)
def test_unfit_artefacts_are_named(tmp_path: Path, changes: dict[str, object], words: str) -> None:
    sphere = SPHERE.model_copy(update=changes)
    folder = SphereSession(tmp_path / "t", Faults(articulations=1), sphere).write()
    result = evaluate_performance(folder)
    assert words in str(result.problems[0])
    assert set(values(result).values()) == {None}


def test_a_form_is_not_decided_by_a_sphere_without_one(tmp_path: Path) -> None:
    sphere = SPHERE.model_copy(update={"form_um": 0.0, "form_sd_um": 0.0})
    faults = Faults(articulations=0, touch_sd_mm=0.003)
    limits = limits_um({"form-touch": 60, "size-touch": 60})
    result = write_performance(SphereSession(tmp_path / "t", faults, sphere, limits).write())
    found = figures_of(result)
    assert found["form-touch"].value == pytest.approx(11, abs=8)
    assert found["form-touch"].decision == "uncertain"
    file = tmp_path / "certificate.xml"
    export_result(result, "dcc", file, Issuer("Lab", "DE"))
    # both limits of the size; of the form none, whose guard band is not known
    assert file.read_text().count("basic_acceptanceLimit") == 2
    assert "states no form" in str(found["form-touch"].reason)
    assert found["form-touch"].test_uncertainty is None
    assert "states no form" in str(result.problems[0])
    assert found["size-touch"].decision == "pass"


def test_a_run_that_was_stopped_says_what_is_missing(tmp_path: Path) -> None:
    result = evaluated(tmp_path / "t", articulations=3)
    assert set(values(result).values()) == {None}
    assert "only 3 of the 5 articulations" in problem(result, "location-scan")
    assert "only 3 of the 5 articulations" in problem(result, "size-touch")
    assert result.spheres[0].moved_um == pytest.approx(0, abs=0.01)


def test_uncovered_patches_are_named(tmp_path: Path) -> None:
    result = evaluated(tmp_path / "t", articulations=1)
    assert values(result)["form-scan"] is None
    assert "do not cover the patches" in problem(result, "form-scan")


def test_two_articulations_that_are_nearly_the_same_give_no_location(tmp_path: Path) -> None:
    result = evaluated(tmp_path / "t", second_like_first=True)
    found = values(result)
    for quantity in ("location-touch", "location-scan"):
        assert found[quantity] is None
        assert "articulations 1 and 2 are nearly the same" in problem(result, quantity)
    assert found["size-touch"] == pytest.approx(0, abs=0.01)
    assert result.offset is None
    assert result.spheres[0].location_fixed_um is None
    notes = [str(note) for note in result.notes if "articulation 2" in str(note)]
    assert len(notes) == 2
    assert "the stylus was held" in notes[0]
    assert "the camera looked" in notes[1]


def test_sizes_are_brought_to_20_degrees_with_their_uncertainty(tmp_path: Path) -> None:
    warm = SPHERE.model_copy(
        update={"expansion_per_c": 11.5e-6, "expansion_sd_per_c": 2e-6, "form_um": 0.0}
    )
    folder = SphereSession(tmp_path / "t", Faults(articulations=0), warm).write()
    unstated = evaluate_performance(folder)
    assert "temperature was not stated" in str(unstated.notes[-1])
    result = evaluate_performance(planned(folder, artefact_c=30.0, temperature_sd_c=0.5))
    # what measures 25 mm at 30 °C is 25 mm * 11.5e-6 * 10 smaller at 20 °C
    assert values(result)["size-touch"] == pytest.approx(-25e3 * 11.5e-5, abs=0.01)
    size = figures_of(result)["size-touch"]
    expected = 2 * np.sqrt(0.2**2 + (25e3 * 11.5e-6 * 0.5) ** 2 + (25e3 * 2e-6 * 10) ** 2)
    assert size.test_uncertainty == pytest.approx(expected, rel=1e-6)
    assert "30.0 °C" in str(result.notes[-1]) or "30 °C" in str(result.notes[-1])


def test_limits_decide_by_the_rule_of_the_plan(tmp_path: Path) -> None:
    limits = limits_um({"form-touch": 30, "size-touch": 1, "dispersion-scan": 60})
    faults = Faults(tip_excess_mm=0.01, **QUIET)
    result = write_performance(SphereSession(tmp_path / "t", faults, limits=limits).write())
    decisions = {one.quantity: one.decision for one in result.figures if one.limit is not None}
    assert decisions == {"form-touch": "pass", "size-touch": "fail", "dispersion-scan": "pass"}
    assert result.verdict.result == "fail"
    assert read_performance(tmp_path / "t") == result


def test_a_limit_that_nothing_is_measured_for_is_named(tmp_path: Path) -> None:
    folder = with_faults(tmp_path / "t")
    limits = limits_um({"form-touch": 9, "length-touch": 9})
    notes = [str(note) for note in evaluate_performance(planned(folder, limits=limits)).notes]
    assert [note for note in notes if "a limit for" in note] == [
        "The plan has a limit for “error of length by touch”, which this test does not measure: "
        "it is not used."
    ]
    planned(folder, limits=limits[:1] * 2)
    with pytest.raises(OperationError, match="form-touch has more than one limit"):
        evaluate_performance(folder)


def test_the_same_folder_gives_the_same_figures(tmp_path: Path) -> None:
    folder = with_faults(tmp_path / "t", **QUIET)
    ended_at = "2026-11-26T11:00:00+00:00"
    assert evaluate_performance(folder, ended_at) == evaluate_performance(folder, ended_at)


def test_a_folder_without_a_plan_is_refused(tmp_path: Path) -> None:
    with pytest.raises(OperationError):
        read_plan(tmp_path)


def test_a_wrong_link_shows_in_the_location(tmp_path: Path) -> None:
    """It moves the sphere from articulation to articulation, and hardly changes its size."""
    clean = SphereSession(tmp_path / "c", Faults(articulations=0), joints=True).write()
    found = values(evaluate_performance(clean))
    for quantity in ("size-touch", "form-touch", "location-touch"):
        assert found[quantity] == pytest.approx(0, abs=0.01)
    assert found["size-scan"] is None
    faults = Faults(link_mm=0.1, articulations=0)
    wrong = SphereSession(tmp_path / "w", faults, joints=True).write()
    shown = known(evaluate_performance(wrong))
    assert shown["location-touch"] > 10
    assert abs(shown["size-touch"]) < shown["location-touch"]


def change_touches(folder: Path, change: Callable[[list[str]], list[str]]) -> None:
    """Writes the touches with other rows."""
    path = folder / TOUCHES
    head, *rows = path.read_text().splitlines()
    path.write_text("\n".join([head, *change(rows)]) + "\n")


def test_nothing_is_stated_of_a_sphere_that_was_not_touched_again(tmp_path: Path) -> None:
    faults, limits = Faults(articulations=0, touch_sd_mm=0.003), limits_um({"form-touch": 30})
    folder = SphereSession(tmp_path / "t", faults, limits=limits).write()
    change_touches(folder, lambda rows: [row for row in rows if "p1-end" not in row])
    result = evaluate_performance(folder)
    figure = figures_of(result)["form-touch"]
    assert figure.value is None
    assert (figure.decision, result.verdict.result) == ("none", "uncertain")
    assert "not touched again at the end" in str(figure.reason)


def test_touches_on_too_few_places_give_no_size_and_no_form(tmp_path: Path) -> None:
    folder = with_faults(tmp_path / "t", articulations=0, **QUIET)

    def crowd(rows: list[str]) -> list[str]:
        pattern = [row for row in rows if "p1-pattern" in row]
        others = [row for row in rows if "p1-pattern" not in row]
        return [pattern[i // 2] for i in range(25)] + others

    change_touches(folder, crowd)
    result = evaluate_performance(folder)
    assert values(result)["size-touch"] is values(result)["form-touch"] is None
    assert "no touch lies near the places 14, 15" in problem(result, "size-touch")


def test_a_sphere_that_stands_still_is_not_said_to_have_moved(tmp_path: Path) -> None:
    for seed in range(12):
        faults = Faults(articulations=0, touch_sd_mm=0.01, seed=seed)
        result = evaluate_performance(SphereSession(tmp_path / str(seed), faults).write())
        assert not result.problems, seed


def test_of_two_positions_each_is_judged(tmp_path: Path) -> None:
    """By its own scatter, and the error of the probe matrix is that of the one that counts."""
    folder = with_faults(tmp_path / "one", **QUIET)
    off = with_faults(tmp_path / "two", matrix_offset_mm=(0.05, 0.0, 0.0), outliers=0.04, **QUIET)
    _, *rows = (off / TOUCHES).read_text().splitlines()
    change_touches(folder, lambda own: [*own, *(row.replace("p1-", "p2-") for row in rows)])
    for number in range(1, 6):
        shutil.copytree(off / sphere_scan(1, number), folder / sphere_scan(2, number))
    result = evaluate_performance(planned(folder, positions=2))
    assert not result.problems
    assert present(result.offset).offset_mm[0] == pytest.approx(0.05, abs=0.005)
    causes = [str(note) for note in result.notes if "far off the sphere" in str(note)]
    assert [cause.startswith("position 2: ") for cause in causes] == [True]
    shutil.rmtree(folder / sphere_scan(2, 5))
    assert evaluate_performance(folder).offset is None


def set_extraction(monkeypatch: pytest.MonkeyPatch, *texts: str) -> None:
    """The recordings of the next session say that they were taken by these settings."""
    said = iter(texts)

    def writer(path: Path, names: list[str] | None) -> RecordingWriter:
        return RecordingWriter(path, names, {EXTRACTION: next(said)})

    monkeypatch.setattr(synthetic_sphere, "RecordingWriter", writer)


def test_every_filter_is_declared(
    perfect: PerformanceFile, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    assert any("no filter is applied" in str(note) for note in perfect.notes)
    set_extraction(monkeypatch, *['{"smoothing_px": 3.0, "threshold": 40.0}'] * 5)
    result = evaluated(tmp_path / "t")
    assert not result.problems
    notes = " ".join(map(str, result.notes))
    assert "smoothed along the laser line by 3 px" in notes
    assert "threshold = 40.0" in notes
    assert "no filter" not in notes


def test_scans_of_two_settings_are_no_set(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    set_extraction(monkeypatch, "", "", '{"threshold": 40.0}', "", "")
    folder = with_faults(tmp_path / "t")
    result = evaluate_performance(folder)
    assert set(values(result).values()) == {None}
    assert "p1-a3 was taken with other settings than p1-a1" in str(result.problems[0])
    # one that was put aside does not count
    shutil.move(folder / "p1-a3", folder / "p1-a3-aside-1")
    shutil.copytree(folder / "p1-a2", folder / "p1-a3")
    assert not any("settings" in str(one) for one in evaluate_performance(folder).problems)


def shake(row: str, random: np.random.Generator) -> str:
    """A touch with the tip elsewhere, by a tenth of a millimetre along each axis."""
    feature, *cells = row.split(",")
    xyz = np.array(cells[:3], dtype=float) + 0.1 * random.normal(size=3)
    return ",".join([feature, *map(repr, xyz.tolist()), *cells[3:]])


LOOSE = [("location", "in the articulations"), ("pattern", "in the 25 places")]
LOOSE += [("end", "at the end")]


@pytest.mark.parametrize(("part", "said"), usual(LOOSE, 1, pytest.mark.soak))
def test_a_sphere_that_gives_way_has_no_symbols(tmp_path: Path, part: str, said: str) -> None:
    folder, random = with_faults(tmp_path / "t", **QUIET), np.random.default_rng(1)
    of_part = f"p1-{part}"
    change_touches(folder, lambda rows: [shake(r, random) if of_part in r else r for r in rows])
    result = evaluate_performance(folder)
    assert set(values(result).values()) == {None}
    assert f"gives way while it is touched {said}" in str(result.problems[-1])


def test_a_test_ended_with_its_last_touch_or_scan(tmp_path: Path) -> None:
    """Where its folder tells, whenever it is evaluated."""
    folder = with_faults(tmp_path / "t", articulations=1)
    assert parse_moment(evaluate_performance(folder).ended_at) > datetime(2026, 11, 26, tzinfo=UTC)
    path = folder / TOUCHES
    head, *rows = path.read_text().splitlines()
    timed = [f"{row},2026-10-01T09:{i:02}:00.250Z" for i, row in enumerate(rows)]
    path.write_text("\n".join([f"{head},touched_at", *timed]))
    assert evaluate_performance(folder).ended_at == "2026-10-01T09:54:00Z"
    (recording,) = folder.glob("*/scan.mcap")
    recording.unlink()
    started = {SCAN_STARTED: "2026-10-01T10:00:00Z"}
    with RecordingWriter(recording, ["J1"], started) as writer:
        for second in (7, 12):
            writer.joints(second * 10**9, [0.0])
    assert last_measured_at(folder) == "2026-10-01T10:00:05Z"
    recording.write_bytes(b"damaged")
    assert last_measured_at(folder) == "2026-10-01T09:54:00Z"


def test_a_new_evaluation_keeps_what_only_the_station_knew(tmp_path: Path) -> None:
    folder = with_faults(tmp_path / "t", articulations=0, touch_sd_mm=0.003)
    first = write_performance(folder)
    taken_back = message("performance-touches-taken-back", count=3)
    known = {"ended_at": "2026-11-20T10:00:00Z", "temperature_c": (21.4, 21.6)}
    first.model_copy(update={**known, "notes": (*first.notes, taken_back)}).write(folder / RESULT)
    again = write_performance(folder)
    assert (again.ended_at, again.temperature_c) == tuple(known.values())
    assert again.notes == (*first.notes, taken_back)
    assert read_performance(folder) == again


@pytest.mark.parametrize(
    ("faults", "joints", "said"),
    [
        ({"tip_excess_mm": -0.03, "articulations": 0}, False, "the tip is worn or smaller"),
        ({"tip_excess_mm": 0.03, "articulations": 0}, False, "the tip is larger than stated"),
        ({"link_mm": 0.3, "articulations": 0}, True, "links or encoders of the arm"),
        ({"outliers": 0.04}, False, "of the points of the scans lie far off the sphere"),
        ({}, False, ""),
    ],
)
def test_the_error_that_the_figures_show_is_named(
    tmp_path: Path, faults: dict[str, Any], joints: bool, said: str
) -> None:
    session = SphereSession(tmp_path / "t", Faults(**{**QUIET, **faults}), joints=joints)
    causes = [
        note
        for note in evaluate_performance(session.write()).notes
        if isinstance(note, Message) and note.message_id.startswith("performance-cause")
    ]
    assert len(causes) == bool(said)
    assert all(said in str(cause) for cause in causes)
