"""Device drivers, their interfaces, and a simulated station.

Of ``app`` it imports only what both share: ``crenel.native`` and ``crenel.messages``.

Your own arm or camera, in your own package
===========================================
1. Write a class with the methods of ``crenel_hardware.interfaces.ArmDriver`` (or
   ``SensorDriver``), and a function that creates one from the options::

       from typing import Annotated

       from crenel_hardware.options import Options, Shown, read_options

       class MyOptions(Options):
           title = "My arm"  # in the list of drivers
           address: Annotated[str, Shown("Address of the controller")]
           rate_hz: float = 500.0  # a form shows "Rate (Hz)"

       def from_options(options):  # the keys of [arm], without ``driver``
           return MyArm(read_options(MyOptions, options, "arm"))

2. Register the function in your pyproject.toml and install your package in the same
   environment (cameras: the group ``crenel.sensors``)::

       [project.entry-points."crenel.arms"]
       my-arm = "my_package.arm:from_options"

3. Name it in station.toml: ``[arm] driver = "my-arm"  address = "192.168.1.20"``.

The rules: the driver does not access its device before ``open``, and ``open`` on an open
device does nothing. ``read`` waits no longer than its timeout and returns time stamps that
strictly increase, on the clock of ``crenel_hardware.clock``. A missing or lost device raises
``DeviceError`` with a remedy; after that, ``open`` tries again. ``close`` may be called
repeatedly, at any time and from any thread, and ends a waiting ``read``. ``health`` counts
losses. ``tests/hardware/conformance.py`` checks all these rules: run it on your driver.
"""
