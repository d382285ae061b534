"""Uses a driver package of one's own by name, and runs the conformance suite on it.

``driver_package`` holds the package: two drivers (``my_drivers.py``), their tests, and a
``pyproject.toml`` with the entry points. ``vendor_sdk.py`` simulates the devices.
"""

import shutil
import sys
import tempfile
import tomllib
from pathlib import Path

import pytest

from crenel_hardware.errors import DeviceError
from crenel_hardware.interfaces import JointSample
from crenel_hardware.registry import arm_driver, arm_drivers, sensor_driver, sensor_drivers

PACKAGE = Path(__file__).with_name("driver_package")


def install(site: Path) -> None:
    """Leaves what ``pip install docs/examples/driver_package`` leaves: modules and entry points."""
    for module in ("my_drivers.py", "vendor_sdk.py"):
        shutil.copy(PACKAGE / module, site)
    project = tomllib.loads((PACKAGE / "pyproject.toml").read_text())["project"]
    info = site / "my_drivers-1.0.dist-info"
    info.mkdir()
    (info / "METADATA").write_text("Metadata-Version: 2.1\nName: my-drivers\nVersion: 1.0\n")
    lines = []
    for group, entries in project["entry-points"].items():
        lines += [f"[{group}]", *(f"{name} = {target}" for name, target in entries.items())]
    (info / "entry_points.txt").write_text("\n".join(lines))
    sys.path.insert(0, str(site))


def main(site: Path) -> int:
    install(site)
    print("arm drivers:", ", ".join(arm_drivers()))
    print("sensor drivers:", ", ".join(sensor_drivers()))

    # The name and the options, as the table [arm] of station.toml gives them.
    arm = arm_driver("my-arm", {"address": "arm-1"})
    print("arm:", arm.open())
    sample = next(record for record in arm.read(1.0) if isinstance(record, JointSample))
    print("joints:", [round(angle, 3) for angle in sample.joints_rad], "rad")
    arm.close()

    camera = sensor_driver("my-camera", {"address": "camera-1"})
    print("sensor:", camera.open())
    camera.set_laser(True)
    frame = camera.read(1.0)
    assert frame is not None
    print(f"frame: {frame.image.shape} {frame.image.dtype}, laser on: {frame.laser_on}")
    camera.close()

    try:
        arm_driver("my-arm", {"adress": "arm-1"})
    except DeviceError as error:
        print("a wrong option:", error)

    return int(pytest.main(["-n0", "-p", "no:cacheprovider", str(PACKAGE)]))


if __name__ == "__main__":
    with tempfile.TemporaryDirectory() as temporary:
        sys.exit(main(Path(temporary)))
