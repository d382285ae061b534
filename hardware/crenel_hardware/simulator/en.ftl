simulated-camera-is-lost = The simulated camera is disconnected
simulated-sensor-cannot-deliver = The simulated sensor cannot deliver that
simulated-sensor-is-not-open = The simulated sensor is not open
turn-fault-switch-camera-lost-off = Its fault switch camera_faults.lost is on; turn it off.
