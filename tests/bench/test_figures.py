"""``.ci/figures``: every figure is in its document, and a value gets the right verdict."""

import json
import re
from collections import Counter
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

from tests.bench.figures import measure
from tests.bench.figures.__main__ import choose, main, show
from tests.bench.figures.everything import FIGURES, NOT_MEASURED, README_NOT_MEASURED
from tests.bench.figures.figure import (
    Better,
    Command,
    Figure,
    Outcome,
    Verdict,
    compare,
    read_printed,
)
from tests.bench.figures.printed import (
    ACCURACY,
    README,
    ROOT,
    WELL,
    Place,
    PrintedNumber,
    Quotient,
    UnreadableError,
    parse_number,
    section_lines,
    tables,
)
from tests.bench.figures.readings import at
from tests.bench.figures.tolerances import count_of, exactly, rms_of, within
from tests.bench.real_folder import BOARDS, lay_out

COMMAND = re.compile(r"`((?:python -m tests.bench |python -m tests|pytest )[^`]*)`")
POINTS = Place(ACCURACY, "Claimed and observed uncertainty", ("8 poses",), "points")


def figure_of(better: Better = Better.SMALLER, *places: Place, allowed: float = 0.0) -> Figure:
    """One that is measured by a command that prints ``{"value": ...}``."""
    command = Command("python -m tests.bench nothing")
    tolerance = within(allowed, "stated")
    return Figure("figure", command, places or (POINTS,), at("value"), better, tolerance)


def verdict_of(better: Better, measured: object, allowed: float = 0.1) -> Verdict:
    return compare(figure_of(better, allowed=allowed), {"value": measured}).verdict


def test_every_figure_is_in_its_document() -> None:
    assert len(FIGURES) > 300
    assert [name for name, count in Counter(one.name for one in FIGURES).items() if count > 1] == []
    for figure in FIGURES:
        assert read_printed(figure).rounding > 0, figure.name
        assert figure.allowed(read_printed(figure)) > 0, figure.name


def test_every_command_of_the_page_is_run_or_its_reason_is_stated() -> None:
    text = " ".join((ROOT / ACCURACY).read_text("utf-8").split())
    in_page = set(COMMAND.findall(text))
    run = {figure.command.documented for figure in FIGURES}
    assert len(in_page) > 20
    assert run <= in_page
    assert set(NOT_MEASURED) <= in_page
    assert not run & set(NOT_MEASURED)
    known = run | set(NOT_MEASURED)
    for command in in_page:
        assert any(f"{one} ".startswith(f"{command} ") for one in known), command


def test_every_row_of_the_readme_is_measured_or_its_reason_is_stated() -> None:
    (table,) = tables(section_lines(README, WELL))
    labels = [row[0] for row in table[1]]
    printed = (place for figure in FIGURES for place in figure.places)
    places = [one.of if isinstance(one, Quotient) else one for one in printed]
    measured = {one.row[0] for one in places if isinstance(one, Place) and one.page == README}
    assert len(labels) > 10
    assert not measured & set(README_NOT_MEASURED)
    for label in labels:
        assert sum(label.startswith(name) for name in measured | set(README_NOT_MEASURED)), label


@pytest.mark.parametrize(
    ("better", "worse", "holds", "better_by_much"),
    [
        (Better.SMALLER, 1.14, 1.12, 0.92),
        (Better.LARGER, 0.92, 0.94, 1.14),
        (Better.AS_PRINTED, 0.92, 1.13, None),
        (Better.NEAR_ONE, 1.14, 1.13, None),
        (Better.NEAR_ONE, 0.86, 0.88, None),
    ],
)
def test_a_value_gets_its_verdict(
    better: Better, worse: float, holds: float, better_by_much: float | None
) -> None:
    """1.03 is printed, 0.1 and the rounding are allowed."""
    assert verdict_of(better, worse) == Verdict.WORSE
    assert verdict_of(better, holds) == Verdict.HOLDS
    if better_by_much is not None:
        assert verdict_of(better, better_by_much) == Verdict.BETTER
    assert verdict_of(Better.NEAR_ONE, 1.0, allowed=0.01) == Verdict.BETTER


@pytest.mark.parametrize("output", [{}, {"value": None}, {"value": ""}, {"value": "nan"}, [], None])
def test_an_output_that_lacks_the_value_is_unreadable(output: Any) -> None:
    assert compare(figure_of(), output).verdict == Verdict.UNREADABLE
    assert verdict_of(Better.SMALLER, float("nan")) == Verdict.UNREADABLE


@pytest.mark.parametrize(
    "changed",
    [
        *({"section": "Claims"}, {"row": ("9 poses",)}, {"row": ("8 poses,",)}),
        *({"column": "point"}, {"which": 1}, {"pattern": r"(\d+) µm"}),
    ],
    ids=["section", "row", "ambiguous row", "column", "number", "pattern"],
)
def test_a_changed_document_is_unreadable(changed: dict[str, Any]) -> None:
    place = replace(POINTS, **changed)
    found = compare(figure_of(Better.SMALLER, place), {"value": 1.0})
    assert found.verdict == Verdict.UNREADABLE
    assert place.section in found.why


def test_places_that_contradict_each_other_are_unreadable() -> None:
    other = replace(POINTS, column="offset")
    figure = figure_of(Better.SMALLER, POINTS, other)
    with pytest.raises(UnreadableError, match=r"1\.02, another page 1\.03|1\.03.*1\.02"):
        read_printed(figure)


def test_numbers_are_read_as_they_are_printed() -> None:
    assert parse_number("7 370") == PrintedNumber(7370.0, 0.5)
    assert parse_number("−12.50") == PrintedNumber(-12.5, 0.005)
    assert PrintedNumber(0.38, 0.005).agrees_with(PrintedNumber(0.381, 0.0005))
    assert not PrintedNumber(0.378, 0.0005).agrees_with(PrintedNumber(0.381, 0.0005))
    (rows,) = (rows for _, rows in tables(["| a | b |", "| - | - |", "| x | 1 |", "| | 2 |"]))
    assert rows == [("x", "1"), ("x", "2")]


def test_a_texts_first_number_is_read() -> None:
    output = {"rows": [{"name": "a", "rate": "7370 /s"}, {"name": "b", "rate": "1 /s"}]}
    assert at("rows", {"name": "a"}, "rate")(output) == 7370
    with pytest.raises(ValueError, match="unpack"):
        at("rows", {"name": "c"}, "rate")(output)


def test_tolerances_follow_from_the_sample() -> None:
    assert rms_of(200, "tests").of(1.0) == pytest.approx(0.15)
    assert count_of(300, "pictures").of(289.0) == pytest.approx(10.15, abs=0.01)
    assert count_of(40, "sessions", 2.5).of(100.0) == pytest.approx(7.2, abs=0.2)
    assert exactly("counted").of(5.0) == 0


def test_what_a_command_printed_before_is_read_again(tmp_path: Path) -> None:
    figure = figure_of(allowed=0.01)
    kept = tmp_path / f"{measure.file_name(figure.command)}.json"
    kept.write_text(json.dumps({"value": 1.5}))
    (found,) = measure.outcomes([figure], tmp_path)
    assert (found.verdict, found.measured) == (Verdict.WORSE, 1.5)
    kept.write_text("no JSON")
    (found,) = measure.outcomes([figure], tmp_path)
    assert found.verdict == Verdict.UNREADABLE


def test_a_command_runs_once_and_one_that_fails_is_unreadable(tmp_path: Path) -> None:
    fails = figure_of()
    both = list(measure.outcomes([fails, replace(fails, name="again")], tmp_path))
    assert [one.verdict for one in both] == [Verdict.UNREADABLE] * 2
    assert "No such command 'nothing'" in both[0].why


def test_without_samples_nothing_is_run(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(measure, "SHARED", tmp_path / "shared")
    for found in measure.outcomes(choose(["gauge", "lines"]), tmp_path):
        assert found.verdict == Verdict.NOT_MEASURED
        assert "is missing" in found.why


def test_pictures_are_laid_out(real: Path, tmp_path: Path) -> None:
    lay_out(real, tmp_path / "folder")
    for name in BOARDS:
        assert (tmp_path / "folder/boards" / name / "object.json").is_file()
    assert len(list((tmp_path / "folder/lines/calib1").iterdir())) == 8
    assert all(path.exists() for path in (tmp_path / "folder").rglob("*"))


@pytest.mark.parametrize(
    ("verdicts", "complete", "status"),
    [
        ([Verdict.HOLDS, Verdict.BETTER, Verdict.NOT_MEASURED], False, 0),
        ([Verdict.HOLDS, Verdict.NOT_MEASURED], True, 2),
        ([Verdict.HOLDS, Verdict.WORSE], True, 1),
        ([Verdict.WORSE, Verdict.UNREADABLE], False, 2),
    ],
)
def test_the_status_is_that_of_the_worst(
    verdicts: list[Verdict], complete: bool, status: int, capsys: pytest.CaptureFixture[str]
) -> None:
    found = [Outcome(figure_of(), one, PrintedNumber(1.0, 0.05), 2.0) for one in verdicts]
    assert show(found, complete) == status
    printed = capsys.readouterr().out
    assert all(one.value in printed for one in verdicts)


def test_figures_are_listed_by_their_beginning(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["--list", "gauge"]) == 0
    assert capsys.readouterr().out.count("python -m tests.bench gauges") == 6
    with pytest.raises(SystemExit):
        main(["--list", "no such figure"])
