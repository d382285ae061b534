"""Small helpers between our meshes in mm and the 3D view's in metres."""

import numpy as np
import viser
from scipy.spatial.transform import Rotation

from app.metrology.frames import Floats
from app.station.shapes import Mesh

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


def pose_of(T_ab: Floats) -> tuple[Floats, Floats]:
    """Position (3,) in metres and quaternion (w, x, y, z) of a transform (4, 4)."""
    x, y, z, w = Rotation.from_matrix(T_ab[:3, :3]).as_quat()
    return np.asarray(T_ab[:3, 3] * M_PER_MM), np.array([w, x, y, z])
