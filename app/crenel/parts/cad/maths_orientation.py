"""Which side of a mesh's triangles is outside, by their neighbours and the enclosed volume."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from crenel.parts.cad.maths_mesh import PartMesh


@dataclass(frozen=True)
class OrientedMesh:
    """A mesh whose triangles all face outwards, as far as it has an outside."""

    mesh: PartMesh
    turned: int
    """So many triangles faced the other way than those around them."""
    is_inverted: bool
    """All of them faced inwards."""
    one_sided: bool
    """A surface like a Möbius strip, whose sides cannot be distinguished."""


def orient_mesh(mesh: PartMesh) -> OrientedMesh:
    """Turns triangles that face the other way than their neighbours, then all that face inwards.

    A closed surface faces outwards if it encloses a positive volume; an open one stays as most of
    its triangles are, unless all of it encloses a clearly negative volume.
    """
    turn = np.zeros(len(mesh.triangles), np.bool_)
    one_sided = False
    if mesh.edges.turned.any():
        turn, one_sided = _turn_by_neighbours(mesh)
        mesh = _turn_triangles(mesh, turn)
    is_inverted = mesh.volume_mm3 < 0 and bool((mesh.edges.counts == 2).all())
    if is_inverted:
        mesh = _turn_triangles(mesh, np.ones(len(mesh.triangles), np.bool_))
    return OrientedMesh(mesh, int(turn.sum()), is_inverted and not turn.any(), one_sided)


def _turn_by_neighbours(mesh: PartMesh) -> tuple[NDArray[np.bool_], bool]:
    """(T,) which triangles to turn so that neighbours agree, the fewest of each surface; and
    whether a surface has one side only."""
    from scipy.sparse import coo_array
    from scipy.sparse.csgraph import connected_components

    count, edges = len(mesh.triangles), mesh.edges
    first, second = edges.faces[edges.is_shared].T.astype(np.int64)
    swap = edges.turned[edges.is_shared]
    # each triangle twice, as it is and turned: neighbours that agree are connected
    rows = np.concatenate([first, first + count])
    columns = np.concatenate([second + count * swap, second + count * ~swap])
    graph = coo_array((np.ones(len(rows), np.bool_), (rows, columns)), (2 * count, 2 * count))
    _, label = connected_components(graph, directed=False)
    as_is, turned = label[:count], label[count:]
    one_sided = bool((as_is == turned).any())
    # of a surface's two components, the one with more triangles as they are stays
    sizes = np.bincount(as_is, minlength=label.max() + 1)
    turn = (sizes[turned] > sizes[as_is]) | ((sizes[turned] == sizes[as_is]) & (turned < as_is))
    return turn, one_sided


def _turn_triangles(mesh: PartMesh, turn: NDArray[np.bool_]) -> PartMesh:
    triangles = mesh.triangles.copy()
    triangles[turn] = triangles[turn][:, ::-1]
    return PartMesh(mesh.vertices_mm, triangles)
