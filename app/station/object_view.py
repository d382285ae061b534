"""The object that the sensor is calibrated on, in the 3D view."""

import viser

from app.metrology.chessboard.board import Chessboard
from app.metrology.frames import Floats
from app.metrology.objects import CalibrationObject
from app.station.shapes import Mesh, block_mesh, board_meshes
from app.station.views import Colour, add_mesh, pose_of

METAL: Colour = (176, 182, 190)
PAPER: Colour = (232, 232, 228)
INK: Colour = (48, 52, 58)


class ObjectView:
    """Draws it where it lies. For one thread at a time."""

    def __init__(self, server: viser.ViserServer) -> None:
        self._server = server
        self._drawn: list[viser.MeshHandle] = []

    def show(self, T_arm_obj: Floats, item: CalibrationObject) -> None:
        """Draws the object instead of the one before."""
        self.clear()
        position, wxyz = pose_of(T_arm_obj)
        for name, mesh, colour in _parts(item):
            part = add_mesh(self._server, f"/object/{name}", mesh, colour, flat_shading=True)
            part.position, part.wxyz = position, wxyz
            self._drawn.append(part)

    def clear(self) -> None:
        while self._drawn:
            self._drawn.pop().remove()


def _parts(item: CalibrationObject) -> list[tuple[str, Mesh, Colour]]:
    if isinstance(item, Chessboard):
        plate, squares = board_meshes(item)
        return [("plate", plate, PAPER), ("squares", squares, INK)]
    return [("block", block_mesh(item), METAL)]
