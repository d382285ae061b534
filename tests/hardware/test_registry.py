"""Drivers by name: built in, from other packages, and broken ones."""

import sys
import tomllib
from collections.abc import Callable
from pathlib import Path
from textwrap import dedent

import pytest

import hardware
from hardware import registry
from hardware.arm.serial_encoder import SerialEncoderArm
from hardware.errors import DeviceError
from hardware.sensor.grabbing import GrabbingSensor

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


def test_the_installed_package_offers_the_same_drivers() -> None:
    tables = tomllib.loads(PYPROJECT.read_text())["project"]["entry-points"]
    assert tables == registry.BUILT_IN


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
    assert registry.arm_drivers() == sorted(["bench", *registry.BUILT_IN["crenel.arms"]])
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
    assert hardware.__doc__ is not None
    lines = hardware.__doc__.split("::\n\n", 1)[1].split("\n2. ")[0].splitlines()
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
