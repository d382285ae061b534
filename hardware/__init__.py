"""Device drivers, their interfaces, and a simulated station. Never imports ``app``.

Your own arm or camera, in a package of your own
================================================
1. Write a class with the methods of ``hardware.interfaces.ArmDriver`` (or
   ``SensorDriver``), and a function that makes one from the options::

       from hardware.options import Options, read_options

       class MyOptions(Options):
           address: str
           rate_hz: float = 500.0

       def from_options(options):  # the keys of [arm] but ``driver``
           return MyArm(read_options(MyOptions, options, "arm"))

2. Register the function in your pyproject.toml and install your package beside this
   one (cameras: the group ``crenel.sensors``)::

       [project.entry-points."crenel.arms"]
       my-arm = "my_package.arm:from_options"

3. Name it in station.toml: ``[arm] driver = "my-arm"  address = "192.168.1.20"``.

The rules: nothing is touched before ``open``, and ``open`` on an open device does
nothing. ``read`` waits no longer than its limit and yields stamps that strictly
increase, on the clock of ``hardware.clock``. A missing or lost device is a
``DeviceError`` saying what to do; after it, ``open`` tries afresh. ``close`` may come
twice, at any time and from any thread, and ends a waiting ``read``. Losses are counted
in ``health``. ``tests/hardware/conformance.py`` checks all this: run it on your driver.
"""
