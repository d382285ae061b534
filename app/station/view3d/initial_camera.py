"""The initial viewpoint of the 3D view, until a user moves it."""

import numpy as np
import viser

from app.metrology.transforms import Floats

FIELD_OF_VIEW_RAD = float(np.radians(42.0))
ELEVATION_RAD = float(np.radians(26.0))
# Beside the line from the arm's base to the work, so that both are visible.
AZIMUTH_OFFSET_RAD = float(np.radians(-65.0))
# A camera this close to its initial position (as a share of its distance) was not moved.
UNTOUCHED = 0.01


class InitialCamera:
    """Sets the view of new tabs, and of those whose user has not moved it."""

    def __init__(self, server: viser.ViserServer) -> None:
        self._server = server
        server.initial_camera.fov = FIELD_OF_VIEW_RAD
        server.initial_camera.near = 0.005
        server.initial_camera.far = 50.0
        self._at, self._from = np.zeros(3), np.ones(3)
        self.look(np.array([0.3, 0.0, 0.15]), 0.6)

    def look(self, centre_m: Floats, radius_m: float) -> None:
        """Shows a sphere of the arm frame, from beside the line between the base and it."""
        azimuth = np.arctan2(centre_m[1], centre_m[0]) + AZIMUTH_OFFSET_RAD
        across = np.cos(ELEVATION_RAD)
        direction = np.array(
            [across * np.cos(azimuth), across * np.sin(azimuth), np.sin(ELEVATION_RAD)]
        )
        position = centre_m + radius_m / np.sin(FIELD_OF_VIEW_RAD / 2) * direction
        for client in self._server.get_clients().values():
            camera = client.camera
            if self._near(camera.position, self._from) and self._near(camera.look_at, self._at):
                with client.atomic():
                    camera.position = position
                    camera.look_at = centre_m
        self._at, self._from = centre_m, position
        self._server.initial_camera.position = position
        self._server.initial_camera.look_at = centre_m

    def _near(self, found: Floats, put: Floats) -> bool:
        distance = float(np.linalg.norm(self._from - self._at))
        return float(np.linalg.norm(found - put)) < UNTOUCHED * distance
