"""Drivers by name: built in, from other packages, broken ones; and their options as form fields."""

import sys
import tomllib
from collections.abc import Callable, Mapping
from pathlib import Path
from textwrap import dedent
from typing import Annotated, Literal

import pytest
from pydantic import Field, PositiveInt

import crenel_hardware
from crenel.messages.message import Message
from crenel_hardware import registry
from crenel_hardware.arm.serial_encoder import SerialEncoderArm
from crenel_hardware.errors import DeviceError
from crenel_hardware.option_fields import OptionField, option_fields, read_entered
from crenel_hardware.options import Options, Shown, options_model, read_options
from crenel_hardware.registry import DeviceKind, arm_driver, driver_options, sensor_driver
from crenel_hardware.sensor.grabbing import GrabbingSensor
from tests.present import present

PYPROJECT = Path(__file__).resolve().parents[2] / "pyproject.toml"


def install(site: Path, package: str, group: str, entries: str) -> None:
    """Lays a package's metadata out as an installer does."""
    info = site / f"{package}-2.1.dist-info"
    info.mkdir()
    (info / "METADATA").write_text(f"Metadata-Version: 2.1\nName: {package}\nVersion: 2.1\n")
    (info / "entry_points.txt").write_text(f"[{group}]\n{entries}\n")


@pytest.fixture
def site(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.syspath_prepend(tmp_path)
    return tmp_path


def test_every_built_in_driver_loads_and_touches_nothing() -> None:
    arm = registry.arm_driver("serial-encoder", {"url": "/dev/none"})
    assert isinstance(arm, SerialEncoderArm)
    assert {"folder", "opencv"} <= set(registry.sensor_drivers())
    for name, options in (("folder", {"path": "/none"}), ("opencv", {"source": "/none"})):
        sensor = registry.sensor_driver(name, options)
        assert isinstance(sensor, GrabbingSensor)
        sensor.close()


def own_drivers(kind: DeviceKind) -> list[str]:
    """The program's own, as its pyproject.toml registers them."""
    tables = tomllib.loads(PYPROJECT.read_text("utf-8"))["project"]["entry-points"]
    return sorted(tables[f"crenel.{kind}s"])


def test_a_checkout_offers_the_drivers_that_it_registers() -> None:
    assert registry.arm_drivers() == own_drivers("arm")
    assert registry.sensor_drivers() == own_drivers("sensor")


@pytest.mark.parametrize("kind", ["arm", "sensor"])
def test_a_built_in_driver_says_what_it_is_and_names_each_of_its_options(kind: DeviceKind) -> None:
    for name in own_drivers(kind):
        model = present(driver_options(kind, name))
        assert isinstance(model.title, Message), name
        for option in option_fields(model):
            assert isinstance(option.label, Message), (name, option.key)
            assert set(option.words) <= set(option.choices), (name, option.key)


def test_an_unknown_name_lists_what_there_is() -> None:
    with pytest.raises(DeviceError) as caught:
        registry.arm_driver("serial-encodr", {})
    assert "[arm]: there is no driver 'serial-encodr'" in str(caught.value.what)
    assert "Did you mean serial-encoder?" in str(caught.value.remedy)
    with pytest.raises(DeviceError, match="Available drivers: folder, genicam, gentl, opencv"):
        registry.sensor_driver("zzz", {})


def test_a_wrong_option_names_its_table_and_key() -> None:
    with pytest.raises(DeviceError, match=r"\[sensor\]: the driver has no option 'pth'"):
        registry.sensor_driver("folder", {"pth": "x"})


def test_a_driver_of_another_package_is_found(site: Path) -> None:
    (site / "bench_arm.py").write_text(
        "def from_options(options):\n    return ('bench', dict(options))\n"
    )
    install(site, "bench-arm", "crenel.arms", "bench = bench_arm:from_options")
    assert registry.arm_drivers() == sorted(["bench", *own_drivers("arm")])
    made: object = registry.arm_driver("bench", {"port": 3})
    assert made == ("bench", {"port": 3})


@pytest.mark.parametrize(
    ("source", "words"),
    [
        ("import a_module_that_is_nowhere", "ModuleNotFoundError"),
        ("raise ValueError('no licence')", "ValueError: no licence"),
        ("pass", "AttributeError"),
        ("from_options = 7", "is not callable"),
    ],
)
def test_a_broken_package_is_named(site: Path, source: str, words: str) -> None:
    (site / "broken_arm.py").write_text(source)
    install(site, "broken-arm", "crenel.arms", "broken = broken_arm:from_options")
    sys.modules.pop("broken_arm", None)
    with pytest.raises(DeviceError) as caught:
        registry.arm_driver("broken", {})
    assert "the package broken-arm 2.1" in str(caught.value.what)
    assert words in str(caught.value.what)
    assert registry.arm_driver("serial-encoder", {"url": "x"})


def test_two_packages_with_one_name_are_refused(site: Path) -> None:
    install(site, "copy", "crenel.sensors", "folder = copy_of:folder")
    with pytest.raises(DeviceError, match=r"this program, the package copy 2\.1"):
        registry.sensor_driver("folder", {"path": "x"})


def guide_in_the_package() -> str:
    lines = present(crenel_hardware.__doc__).split("::\n\n", 1)[1].split("\n2. ")[0].splitlines()
    return "\n".join(line[7:] for line in lines)


def guide_in_the_documents() -> str:
    page = (Path(__file__).parents[2] / "docs/drivers.md").read_text(encoding="utf-8")
    return dedent(page.split("```python\n", 1)[1].split("   ```", 1)[0])


@pytest.mark.parametrize("read", [guide_in_the_package, guide_in_the_documents])
def test_the_guide_for_driver_authors_works_as_written(site: Path, read: Callable[[], str]) -> None:
    code = read()
    (site / "my_package.py").write_text(
        f"class MyArm:\n    def __init__(self, options):\n        self.options = options\n\n{code}"
    )
    install(site, "my-package", "crenel.arms", "my-arm = my_package:from_options")
    driver = registry.arm_driver("my-arm", {"address": "192.168.1.20"})
    assert driver.options.rate_hz == 500.0  # type: ignore[attr-defined]
    with pytest.raises(DeviceError, match=r"\[arm\]: the option 'address' is missing"):
        registry.arm_driver("my-arm", {})


class BenchOptions(Options):
    late_ms: float = 2.5
    mode: Annotated[
        Literal["fast", "exact"], Shown("Way of counting", "By the manual", {"fast": "in a hurry"})
    ] = "exact"
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
    camera = present(driver_options("sensor", "opencv"))
    first, *_ = option_fields(camera)
    assert (first.key, first.required, first.main) == ("source", True, True)
    industrial = present(driver_options("sensor", "genicam"))
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
    assert (found["mode"].label, found["mode"].help) == ("Way of counting", "By the manual")
    assert found["mode"].words == {"fast": "in a hurry"}
    assert found["late_ms"].label == "Late"
    assert found["range_mm"].label == "Range"
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
