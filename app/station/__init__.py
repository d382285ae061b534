"""The live machine room: devices, scanning, recording, the 3D view, live state."""
