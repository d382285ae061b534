"""Helpers between the meshes in mm and those of the 3D view in metres."""

from dataclasses import dataclass

import numpy as np
import viser
from scipy.spatial.transform import Rotation

from crenel.formats.drawings.glb import glb_bytes
from crenel.metrology.colormaps import Bytes
from crenel.metrology.targets.chessboard import Chessboard
from crenel.metrology.targets.target import CalibrationTarget
from crenel.metrology.transforms import Floats
from crenel.station.view3d.meshes import Mesh, block_mesh, board_meshes

M_PER_MM = 1e-3
Colour = tuple[int, int, int]


def add_mesh(
    server: viser.ViserServer,
    name: str,
    mesh: Mesh,
    colour: Colour,
    *,
    opacity: float | None = None,
    flat_shading: bool = False,
    both_sides: bool = False,
) -> viser.MeshHandle:
    """A mesh as a node of the scene."""
    return server.scene.add_mesh_simple(
        name,
        (mesh.vertices_mm * M_PER_MM).astype(np.float32),
        mesh.faces,
        color=colour,
        opacity=opacity,
        flat_shading=flat_shading,
        side="double" if both_sides else "front",
        cast_shadow=False,
        receive_shadow=False,
    )


def viser_pose(T_ab: Floats) -> tuple[Floats, Floats]:
    """Positions (..., 3) in metres and quaternions (..., 4), as w, x, y, z, of transforms
    (..., 4, 4); one or a row of them."""
    xyzw = Rotation.from_matrix(T_ab[..., :3, :3]).as_quat()
    return T_ab[..., :3, 3] * M_PER_MM, np.roll(xyzw, 1, axis=-1)


TINT: Colour = (64, 120, 235)
OPACITY = 0.16


class ShapeNodes:
    """The drawn shapes, by number."""

    def __init__(self, server: viser.ViserServer) -> None:
        self._server = server
        self._roots: dict[int, viser.FrameHandle] = {}

    def show(self, number: int, mesh: Mesh, label: str) -> None:
        """Draws a shape, with its label at its top."""
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


@dataclass(frozen=True)
class ColouredSurface:
    """Triangles with a colour each."""

    corners_mm: Floats
    """(N, 3, 3)"""
    colours: Bytes
    """(N, 3)"""


class SurfaceNode:
    """A coloured surface in its pose, in place of the clouds. For one thread at a time."""

    def __init__(self, server: viser.ViserServer) -> None:
        self._server = server
        self._drawn: viser.GlbHandle | None = None
        self._made = 0

    def show(self, T_arm_part: Floats, surface: ColouredSurface) -> None:
        """Draws a surface, and removes the former one once it is there."""
        self._made += 1
        former = self._drawn
        position, wxyz = viser_pose(T_arm_part)
        content = glb_bytes(M_PER_MM * surface.corners_mm, surface.colours)
        with self._server.atomic():
            self._drawn = self._server.scene.add_glb(
                f"/surface/{self._made}",
                content,
                position=position,
                wxyz=wxyz,
                cast_shadow=False,
                receive_shadow=False,
            )
            if former is not None:
                former.remove()

    def clear(self) -> None:
        if self._drawn is not None:
            self._drawn.remove()
            self._drawn = None


METAL: Colour = (176, 182, 190)
BOARD_WHITE: Colour = (232, 232, 228)
INK: Colour = (48, 52, 58)


class TargetNode:
    """Draws it in its pose. For one thread at a time."""

    def __init__(self, server: viser.ViserServer) -> None:
        self._server = server
        self._drawn: list[viser.MeshHandle] = []

    def show(self, T_arm_obj: Floats, item: CalibrationTarget) -> None:
        """Draws the object, replacing the previous one."""
        self.clear()
        position, wxyz = viser_pose(T_arm_obj)
        for name, mesh, colour in _parts(item):
            part = add_mesh(self._server, f"/object/{name}", mesh, colour, flat_shading=True)
            part.position, part.wxyz = position, wxyz
            self._drawn.append(part)

    def clear(self) -> None:
        while self._drawn:
            self._drawn.pop().remove()


def _parts(item: CalibrationTarget) -> list[tuple[str, Mesh, Colour]]:
    if isinstance(item, Chessboard):
        plate, squares = board_meshes(item)
        return [("plate", plate, BOARD_WHITE), ("squares", squares, INK)]
    return [("block", block_mesh(item), METAL)]
