simulated-camera-is-lost = Die simulierte Kamera ist nicht mehr verbunden
simulated-sensor-cannot-deliver = Der simulierte Sensor kann das nicht liefern
simulated-sensor-is-not-open = Der simulierte Sensor ist nicht geöffnet
turn-fault-switch-camera-lost-off = Der Fehlerschalter camera_faults.lost ist eingeschaltet; ausschalten.
