"""The live machine room: devices, clocks, scanning, recording, the 3D scene."""
