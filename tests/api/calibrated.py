"""A calibration in use that did not have to be made: what nature knows of the twin."""

import json
from typing import Any

import numpy as np


def use_truth(server: Any, name: str) -> str:
    """Accepts a true calibration of the server's twin under this session's name.

    ``server`` has the twin, the data folder and the context of one.
    """
    truth: dict[str, Any] = json.loads(json.dumps(server.twin.truth()))
    T_cam_sensor = np.array(truth["camera"]["T_cam_sensor"])
    matrix = np.array(truth["camera"]["matrix"])
    config = server.twin.config
    sheet = {
        "format": "crenel/calibration",
        "version": 1,
        "camera": {
            "projection_matrix": (matrix @ T_cam_sensor[:3]).tolist(),
            "matrix": matrix.tolist(),
            "rotation": T_cam_sensor[:3, :3].tolist(),
            "translation_mm": T_cam_sensor[:3, 3].tolist(),
            "distortion": truth["camera"]["distortion"],
            "width_px": config.width_px,
            "height_px": config.height_px,
        },
        "laser_plane": truth["laser_plane"],
        "probe_matrix": truth["T_flange_sensor"],
        "stripe_axis": "u",
        "serial_numbers": {"arm": "", "object": "TWIN-B1", "sensor": "TWIN-S1"},
        "uncertainty": {"total_um": 30.0, "budget": [], "depth_range_mm": [60.0, 240.0]},
    }
    folder = server.data / "sessions" / name
    folder.mkdir(parents=True)
    file = folder / "calibration.json"
    file.write_text(json.dumps(sheet))
    (folder / "arm.json").write_text(json.dumps(server.twin.papers()["arm.json"]))
    figures = {
        "total_um": 30.0,
        "verdict": "good",
        "arm_serial": "",
        "object_serial": "TWIN-B1",
        "sensor_serial": "TWIN-S1",
    }
    store, guide = server.context.store, server.context.guide
    store.journal.begin_session(name, "calibration")
    store.calibrations.accept(name, f"True {name}", file, figures, None)
    guide._on_closed()  # the station works with it from now on
    return name
