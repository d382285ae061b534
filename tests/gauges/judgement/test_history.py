"""The symbols of performance tests over time, from their files."""

from pathlib import Path

from crenel.formats.results.calibration import SerialNumbers
from crenel.formats.results.decision_rule import RulePart
from crenel.gauges.judgement.document import PerformanceFile, read_performance
from crenel.gauges.judgement.evaluate_history import PerformanceSymbols, SymbolValue, read_symbols
from crenel.metrology.decision import EXPANDED_K2
from tests.gauges.judgement.results import (
    contact_result,
    lengths_result,
    plane_result,
    sphere_result,
)


def changed(document: PerformanceFile, folder: Path, **fields: object) -> PerformanceFile:
    """The document with other fields, written again."""
    new = document.model_copy(update=fields)
    new.write(folder / "performance.json")
    return new


def value_of(test: PerformanceSymbols, quantity: str) -> SymbolValue:
    return next(one for one in test.symbols if one.quantity == quantity)


def test_each_test_keeps_its_own_limit_and_rule(tmp_path: Path) -> None:
    first = sphere_result(tmp_path / "a")
    again = sphere_result(tmp_path / "b", seed=6)
    figures = tuple(
        one.model_copy(update={"limit": 10.0}) if one.quantity == "form-touch" else one
        for one in again.figures
    )
    changed(again, tmp_path / "b", id="b", figures=figures, rule=RulePart.of(EXPANDED_K2))
    before, after = read_symbols([tmp_path / "a", tmp_path / "b"])
    assert (before.id, after.id) == (first.id, "b")
    assert (before.artefact_kind, before.arm_serial) == ("sphere", "A-1")
    assert [value_of(one, "form-touch").limit for one in (before, after)] == [45.0, 10.0]
    assert str(before.rule) != str(after.rule)
    stated = next(one for one in first.figures if one.quantity == "form-touch")
    kept = value_of(before, "form-touch")
    assert (kept.value, kept.test_uncertainty) == (stated.value, stated.test_uncertainty)
    assert value_of(before, "size-touch").signed
    assert not kept.signed
    assert value_of(before, "size-all-scan").value is None


def test_kinds_of_artefacts_are_kept_apart(tmp_path: Path) -> None:
    makers = {"bar": lengths_result, "plate": plane_result, "contact": contact_result}
    for name, make in makers.items():
        make(tmp_path / name)
    found = read_symbols([tmp_path / name for name in makers])
    assert [one.artefact_kind for one in found] == ["ball-bar", "plane", "contact"]


def test_tests_without_a_readable_result_are_passed_over(tmp_path: Path) -> None:
    whole, cancelled, damaged = (tmp_path / name for name in ("whole", "cancelled", "damaged"))
    sphere_result(whole)
    cancelled.mkdir()
    damaged.mkdir()
    (damaged / "performance.json").write_text("{")
    (found,) = read_symbols([cancelled, whole, damaged, tmp_path / "gone"])
    assert found.id == read_performance(whole).id


def test_a_result_that_is_written_again_is_read_again(tmp_path: Path) -> None:
    document = sphere_result(tmp_path / "a")
    assert read_symbols([tmp_path / "a"])[0].arm_serial == "A-1"
    serials = SerialNumbers(arm="A-2", sensor="S-1", object="")
    changed(document, tmp_path / "a", serial_numbers=serials)
    assert read_symbols([tmp_path / "a"])[0].arm_serial == "A-2"
