"""Runs the conformance suite on both drivers.

A bench gives the suite a new driver, and its hands on the device: unplug, plug in, press a button.
"""

import pytest
import vendor_sdk
from my_drivers import BUTTONS

from crenel_hardware.interfaces import ArmDriver, Button, SensorDriver
from crenel_hardware.registry import arm_driver, sensor_driver
from tests.hardware.conformance import ArmBench, ArmConformance, SensorBench, SensorConformance

NAMES = {button: name for name, button in BUTTONS.items()}


class MyArmBench(ArmBench):
    def __init__(self) -> None:
        self.device = vendor_sdk.DEVICES["arm-1"] = vendor_sdk.Device(period_us=2_000)

    def driver(self) -> ArmDriver:
        return arm_driver("my-arm", {"address": "arm-1"})

    def contacts(self) -> int:
        return self.device.connections

    def unplug(self) -> None:
        self.device.plugged = False

    def plug_in(self) -> None:
        self.device.plugged = True

    def silence(self, silent: bool) -> None:
        self.device.silent = silent

    def lose_samples(self, count: int) -> None:
        self.device.lose = count

    def set_buttons(self, pressed: set[Button]) -> None:
        self.device.buttons = frozenset(NAMES[button] for button in pressed)


class MyCameraBench(SensorBench):
    def __init__(self) -> None:
        self.device = vendor_sdk.DEVICES["camera-1"] = vendor_sdk.Device(period_us=15_000)

    def driver(self) -> SensorDriver:
        return sensor_driver("my-camera", {"address": "camera-1"})

    def unplug(self) -> None:
        self.device.plugged = False

    def plug_in(self) -> None:
        self.device.plugged = True


class TestMyArm(ArmConformance):
    @pytest.fixture
    def bench(self) -> ArmBench:
        return MyArmBench()


class TestMyCamera(SensorConformance):
    @pytest.fixture
    def bench(self) -> SensorBench:
        return MyCameraBench()
