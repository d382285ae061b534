"""The options of drivers as fields of a form."""

from collections.abc import Mapping
from typing import Literal

import pytest
from pydantic import Field, PositiveInt

from hardware.errors import DeviceError
from hardware.option_fields import OptionField, option_fields, read_entered
from hardware.options import Options, options_model, read_options
from hardware.registry import arm_driver, driver_options, sensor_driver


class BenchOptions(Options):
    late_ms: float = 2.5
    mode: Literal["fast", "exact"] = "exact"
    port: int = Field(ge=1, le=65535, description="Of the controller")
    invert: bool = False
    range_mm: list[float] | None = None
    lines: list[str] = Field(default_factory=list)
    counts: PositiveInt | list[PositiveInt] | None = None
    source: int | str = 0


def from_options(options: Mapping[str, object]) -> BenchOptions:
    return read_options(BenchOptions, options, "arm")


def fields() -> dict[str, OptionField]:
    return {one.key: one for one in option_fields(BenchOptions)}


def test_the_model_is_found_through_the_factory_without_making_a_driver() -> None:
    assert options_model(from_options) is BenchOptions
    assert from_options({"port": 1}).port == 1


def test_a_factory_that_reads_its_options_otherwise_has_no_model() -> None:
    assert options_model(lambda options: options["port"]) is None
    assert options_model(dict) is None


def test_every_built_in_driver_has_its_fields() -> None:
    camera = driver_options("sensor", "opencv")
    assert camera is not None
    first, *_ = option_fields(camera)
    assert (first.key, first.required, first.main) == ("source", True, True)
    industrial = driver_options("sensor", "genicam")
    assert industrial is not None
    assert [one.key for one in option_fields(industrial)][:2] == ["address", "serial_number"]


def test_kinds_units_and_defaults() -> None:
    found = fields()
    kinds = {
        "number": {"late_ms", "port"},
        "choice": {"mode"},
        "switch": {"invert"},
        "list": {"range_mm", "lines"},
        "text": {"counts", "source"},
    }
    for kind, keys in kinds.items():
        assert {key for key, one in found.items() if one.kind == kind} == keys
    assert (found["late_ms"].unit, found["late_ms"].default) == ("ms", "2.5")
    assert found["mode"].choices == ("fast", "exact")
    assert found["invert"].default == "false"
    assert found["range_mm"].default == ""


def test_what_is_required_comes_first_and_what_is_rarely_needed_last() -> None:
    assert list(fields())[:2] == ["port", "source"]
    assert fields()["port"].help == "Of the controller"
    assert not fields()["late_ms"].main


def test_entered_texts_get_the_types_of_the_options() -> None:
    single = {"late_ms": "3", "port": " 7431 ", "invert": "true", "mode": ""}
    several = {"range_mm": "1, 2.5", "lines": "Line1, Line2", "counts": "4096, 8192"}
    entered = {**single, **several, "source": "/dev/video0"}
    typed = read_entered(BenchOptions, entered)
    wanted = {"late_ms": 3, "port": 7431, "invert": True, "range_mm": [1, 2.5]}
    lists = {"lines": ["Line1", "Line2"], "counts": [4096, 8192]}
    assert typed == {**wanted, **lists, "source": "/dev/video0"}
    assert from_options(typed).counts == [4096, 8192]


@pytest.mark.parametrize(
    ("text", "lines"),
    [("Line1", ["Line1"]), ('["Line1"]', ["Line1"]), ("7, Line1", ["7", "Line1"])],
)
def test_a_list_of_texts_is_entered_with_commas(text: str, lines: list[str]) -> None:
    assert read_entered(BenchOptions, {"lines": text}) == {"lines": lines}
    assert read_entered(BenchOptions, {"range_mm": "4"}) == {"range_mm": [4]}


def test_a_number_is_a_text_where_the_option_is_one() -> None:
    model = driver_options("arm", "serial-encoder")
    assert read_entered(model, {"url": "5"}) == {"url": "5"}
    assert read_entered(driver_options("sensor", "opencv"), {"source": "0"}) == {"source": 0}


def test_a_value_that_does_not_fit_is_named_by_the_driver() -> None:
    typed = read_entered(driver_options("sensor", "opencv"), {"source": "0", "rate_hz": "-5"})
    with pytest.raises(DeviceError, match="rate_hz"):
        sensor_driver("opencv", typed)
    with pytest.raises(DeviceError, match="'speed'"):
        arm_driver("serial-encoder", read_entered(None, {"url": "x", "speed": "5"}))


def test_without_a_model_what_looks_like_a_number_is_one() -> None:
    assert read_entered(None, {"a": "5", "b": "x", "c": True}) == {"a": 5, "b": "x", "c": True}
