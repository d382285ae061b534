"""Viewpoints of the 3D view: the initial one, and those that a page can choose."""

from collections import deque
from collections.abc import Callable
from typing import Literal

import numpy as np
import viser

from crenel.errors import OperationError
from crenel.messages.message import message
from crenel.metrology.transforms import Floats
from crenel.station.view3d.selection import ViewCamera

Viewpoint = Literal["above", "front", "side", "whole"]
Vector = tuple[float, float, float]
Turn = Callable[[Vector, Vector], None]
"""Moves the camera of a browser to a position, and turns it to a point, in metres."""

DIRECTIONS: dict[str, Vector] = {
    "above": (0.0, -1e-3, 1.0),  # not along the vertical, about which the view is turned
    "front": (0.0, -1.0, 0.0),
    "side": (1.0, 0.0, 0.0),
}
"""From what is seen to the camera, in the arm frame; X is to the right from above and in front."""
MARGIN = 1.05


def place_camera(
    viewpoint: Viewpoint, camera: ViewCamera, centre_m: Floats, radius_m: float
) -> Floats:
    """Position (3,) in metres from which a page sees a sphere of the arm frame as a whole.

    Args:
        camera: the page's present one; ``whole`` keeps its direction.
    """
    away = -camera.direction() if viewpoint == "whole" else np.array(DIRECTIONS[viewpoint])
    half_rad = np.arctan(np.tan(camera.fov_rad / 2) * min(1.0, camera.aspect))
    distance_m = MARGIN * radius_m / np.sin(half_rad)
    return np.asarray(centre_m + distance_m * away / np.linalg.norm(away))


class PageCameras:
    """The viewpoints of the browsers that show the view, each by a key of its own."""

    def __init__(self, content_sphere_m: Callable[[], tuple[Floats, float]]) -> None:
        self._content_sphere_m = content_sphere_m
        self._pages: dict[str, tuple[ViewCamera, Turn]] = {}

    def __len__(self) -> int:
        return len(self._pages)

    def look(self, key: str, camera: ViewCamera, turn: Turn) -> None:
        """Sets the present viewpoint of the browser with this key, and how it is changed."""
        self._pages[key] = camera, turn

    def leave(self, key: str, camera: ViewCamera) -> None:
        """Removes the last viewpoint of this browser."""
        if key in self._pages and self._pages[key][0] is camera:
            del self._pages[key]

    def camera_of(self, key: str) -> ViewCamera:
        """The viewpoint of the browser with this key.

        Raises:
            OperationError: the browser is unknown.
        """
        return self._page(key)[0]

    def turn(self, key: str, viewpoint: Viewpoint) -> None:
        """Shows the clouds, or the arm before there are any, in the browser with this key.

        Raises:
            OperationError: the browser is unknown.
        """
        camera, turn = self._page(key)
        centre_m, radius_m = self._content_sphere_m()
        turn(_vector(place_camera(viewpoint, camera, centre_m, radius_m)), _vector(centre_m))

    def _page(self, key: str) -> tuple[ViewCamera, Turn]:
        page = self._pages.get(key)
        if page is None:
            raise OperationError(
                "no-view",
                message("view-3d-not-connected"),
                remedy=message("wait-moment-load-page-again"),
            )
        return page


def _vector(point: Floats) -> Vector:
    x, y, z = point.tolist()
    return x, y, z


FIELD_OF_VIEW_RAD = float(np.radians(42.0))
ELEVATION_RAD = float(np.radians(26.0))
# Beside the line from the arm's base to the work, so that both are visible.
AZIMUTH_OFFSET_RAD = float(np.radians(-65.0))
# A camera this close to its initial position (as a share of its distance) was not moved.
UNTOUCHED = 0.01
REMEMBERED = 32
"""Places where cameras were put."""


class InitialCamera:
    """Sets the view of new tabs, and of those whose user has not moved it."""

    def __init__(self, server: viser.ViserServer) -> None:
        self._server = server
        server.initial_camera.fov = FIELD_OF_VIEW_RAD
        server.initial_camera.near = 0.005
        server.initial_camera.far = 50.0
        self.radius_m = 1.0
        self._at = np.zeros(3)
        self._put: deque[tuple[Floats, Floats]] = deque(maxlen=REMEMBERED)
        self.look(np.array([0.3, 0.0, 0.15]), 0.6)

    @property
    def centre_m(self) -> Floats:
        """Centre (3,) of the sphere that is shown."""
        return self._at

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
            if self._is_untouched(camera.position, camera.look_at):
                with client.atomic():
                    camera.position = position
                    camera.look_at = centre_m
        self._at, self.radius_m = centre_m, radius_m
        self._put.append((position, centre_m))
        self._server.initial_camera.position = position
        self._server.initial_camera.look_at = centre_m

    def _is_untouched(self, position_m: Floats, at_m: Floats) -> bool:
        """Whether a browser's camera is where it was put; a slow browser still tells where it was
        before."""
        return any(
            max(np.linalg.norm(position_m - position), np.linalg.norm(at_m - at))
            < UNTOUCHED * np.linalg.norm(position - at)
            for position, at in self._put
        )
