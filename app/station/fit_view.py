"""Fitted shapes in the 3D view: translucent, with their names."""

import numpy as np
import viser

from app.station.shapes import Mesh
from app.station.views import M_PER_MM, Colour, add_mesh

TINT: Colour = (64, 120, 235)
OPACITY = 0.16


class FitViews:
    """The shapes that are drawn, by their numbers."""

    def __init__(self, server: viser.ViserServer) -> None:
        self._server = server
        self._roots: dict[int, viser.FrameHandle] = {}

    def show(self, number: int, mesh: Mesh, label: str) -> None:
        """Draws one; its label stands at its top."""
        root = f"/fits/{number}"
        with self._server.atomic():
            self._roots[number] = self._server.scene.add_frame(root, show_axes=False)
            add_mesh(self._server, f"{root}/shape", mesh, TINT, opacity=OPACITY, both_sides=True)
            top = mesh.vertices_mm[np.argmax(mesh.vertices_mm[:, 2])]
            self._server.scene.add_label(
                f"{root}/label", label, position=top * M_PER_MM, anchor="bottom-center"
            )

    def hide(self, number: int) -> None:
        root = self._roots.pop(number, None)
        if root is not None:
            root.remove()

    def clear(self) -> None:
        for number in tuple(self._roots):
            self.hide(number)
