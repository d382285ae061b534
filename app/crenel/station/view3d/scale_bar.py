"""A scale bar next to the clouds in the 3D view, with its true length."""

import numpy as np
import viser

from crenel.metrology.transforms import Floats
from crenel.station.view3d.meshes import Mesh, box, join_meshes
from crenel.station.view3d.nodes import M_PER_MM, Colour, add_mesh

LIGHT: Colour = (206, 212, 220)
DARK: Colour = (66, 74, 86)
ROOT = "/scale"
SHARE = 0.4
"""Maximum length, as a share of the larger side of the clouds."""
PARTS = 5
MOVED_SHARE = 0.02
"""Share of its length by which it must be off before it is moved."""


def round_length_mm(most_mm: float) -> float:
    """The largest of 1, 2, 5, 10 and so on that does not exceed a length."""
    tens = 10.0 ** np.floor(np.log10(most_mm))
    return float(max(step * tens for step in (1.0, 2.0, 5.0) if step * tens <= most_mm * 1.0001))


class ScaleBar:
    """Lies in front of the lower front edge of the cloud; alternately light and dark."""

    def __init__(self, server: viser.ViserServer) -> None:
        self._server = server
        self._root: viser.FrameHandle | None = None
        self._length_mm = 0.0
        self._foot_mm = np.zeros(3)

    def lay(self, low_mm: Floats, high_mm: Floats) -> None:
        """Next to the box of the clouds; drawn again only if another length fits."""
        side = float(max(high_mm[0] - low_mm[0], high_mm[1] - low_mm[1]))
        length = round_length_mm(max(SHARE * side, 1.0))
        foot = low_mm - np.array([0.0, 0.15 * length, 0.0])
        if self._root is not None and length == self._length_mm:
            if np.max(np.abs(foot - self._foot_mm)) > MOVED_SHARE * length:
                self._foot_mm = foot
                self._root.position = foot * M_PER_MM
            return
        self.remove()
        self._length_mm, self._foot_mm = length, foot
        with self._server.atomic():
            self._root = self._server.scene.add_frame(
                ROOT, show_axes=False, position=foot * M_PER_MM
            )
            parts = [self._part(i) for i in range(PARTS)]
            add_mesh(self._server, f"{ROOT}/dark", join_meshes(*parts[::2]), DARK)
            add_mesh(self._server, f"{ROOT}/light", join_meshes(*parts[1::2]), LIGHT)
            self._server.scene.add_label(
                f"{ROOT}/length",
                f"{length:g} mm",
                position=(length / 2 * M_PER_MM, -0.06 * length * M_PER_MM, 0.0),
                anchor="top-center",
            )

    def remove(self) -> None:
        if self._root is not None:
            self._root.remove()
            self._root = None

    def _part(self, number: int) -> Mesh:
        thick, part = 0.012 * self._length_mm, self._length_mm / PARTS
        return box(
            np.array([number * part, -thick, -thick]), np.array([(number + 1) * part, thick, thick])
        )
