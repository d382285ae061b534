"""Reads a part from any file that holds one, checks its surface, and says what was found."""

from dataclasses import dataclass, replace
from functools import cached_property
from pathlib import Path

import numpy as np

from crenel.errors import OperationError
from crenel.formats.file_names import display_path
from crenel.formats.io_errors import convert_io_errors
from crenel.formats.open_file import open_file
from crenel.messages.message import Message, Text, join, message, quantity, rounded
from crenel.parts.cad.document_step import is_step, read_step
from crenel.parts.cad.document_stl import is_stl, read_stl
from crenel.parts.cad.document_triangles import Triangles, mesh_error, scale_triangles
from crenel.parts.cad.maths_closest import MeshTree
from crenel.parts.cad.maths_mesh import PartMesh, mesh_from_corners
from crenel.parts.cad.maths_orientation import orient_mesh
from crenel.parts.cad.maths_smooth import SmoothSurface
from crenel.units import MM_PER

HEAD_BYTES = 1 << 16
NAMED_EDGES = 3
"""So many places of open edges are named."""


@dataclass(frozen=True)
class Part:
    """The nominal shape of a part."""

    mesh: PartMesh
    form: str
    """The format of its file."""
    unit: str
    """Of the file's numbers: mm, m, inch …"""
    has_unit: bool
    """Whether the file or the user states the unit."""
    is_closed: bool
    bodies: int
    """How many bodies its file has; not known of triangles: 1."""
    notes: tuple[Text, ...]
    """What was found of its surface and done about it."""

    @cached_property
    def tree(self) -> MeshTree:
        """By which its closest points are found."""
        return MeshTree(self.mesh)

    @cached_property
    def surface(self) -> SmoothSurface:
        """For which its facets stand."""
        return SmoothSurface(self.mesh)

    @property
    def chord_error_mm(self) -> float:
        """How far its curved surfaces may be from their triangles, at most."""
        return float(self.mesh.chord_errors_mm.max(initial=0.0))


def read_part(
    path: Path,
    unit: str | None = None,
    tolerance_mm: float | None = None,
    body: int | None = None,
) -> Part:
    """Reads the part of a file: STL or STEP.

    Args:
        unit: of its numbers, a name of ``MM_PER``; by default as the file states it, else mm.
        tolerance_mm: the width of the tolerance that it is for, by which STEP becomes triangles.
        body: which of several bodies, from 1; by default all.

    Raises:
        OperationError: missing, of another kind, damaged, without triangles, or too large.
    """
    with convert_io_errors(path), open_file(path) as file:
        size = file.seek(0, 2)
        file.seek(0)
        head = file.read(HEAD_BYTES)
        if is_step(head):
            read = read_step(path, tolerance_mm)
        elif is_stl(path, head, size):
            read = read_stl(path, file)
        else:
            raise OperationError(
                "mesh-format-unknown",
                display_path(path),
                message("mesh-format-unknown"),
                message("mesh-give-known-format"),
            )
    return part_from_triangles(path, _select_body(path, read, body), unit)


def _select_body(path: Path, read: Triangles, body: int | None) -> Triangles:
    """The triangles of one body; raises ``OperationError`` where there is no such body."""
    if body is None:
        return read
    bodies = _count_bodies(read)
    if not 1 <= body <= bodies:
        raise OperationError(
            "part-body-missing",
            message("part-has-no-such-body", path=display_path(path), body=body),
            message("part-bodies-there", count=bodies),
        )
    if read.body is None:
        return read
    kept = read.body == body - 1
    return replace(read, corners=read.corners[kept], body=None)


def _count_bodies(read: Triangles) -> int:
    return 1 if read.body is None else int(read.body.max(initial=0)) + 1


def part_from_triangles(path: Path, read: Triangles, unit: str | None = None) -> Part:
    """The part of a file's triangles; raises ``OperationError`` as ``read_part``."""
    mm_per_unit = read.mm_per_unit or 1.0
    if unit is not None and read.mm_per_unit is None:
        mm_per_unit = MM_PER[unit]
    corners, not_numbers = scale_triangles(path, read, mm_per_unit)
    mesh, flat = mesh_from_corners(corners)
    if not len(mesh.triangles):
        raise mesh_error(path, message("mesh-without-triangles"))
    oriented = orient_mesh(mesh)
    notes: list[Text] = []
    bodies = _count_bodies(read)
    if bodies > 1:
        notes.append(message("part-has-bodies", count=bodies))
    if not_numbers:
        notes.append(message("part-triangles-not-numbers", count=not_numbers))
    if flat:
        notes.append(message("part-triangles-without-area", count=flat))
    if oriented.is_inverted:
        notes.append(message("part-normals-inward-turned"))
    elif oriented.turned:
        notes.append(message("part-triangles-turned", count=oriented.turned))
    if oriented.one_sided:
        notes.append(message("part-surface-one-sided"))
    mesh = oriented.mesh
    open_edges = np.flatnonzero(mesh.edges.is_open)
    if len(open_edges):
        notes.append(_open_note(mesh, open_edges))
    if int(np.sum(mesh.edges.counts > 2)):
        count = int(np.sum(mesh.edges.counts > 2))
        notes.append(message("part-edges-of-many-triangles", count=count))
    name = next(name for name, mm in MM_PER.items() if mm == mm_per_unit)
    has_unit = unit is not None or read.mm_per_unit is not None
    if not has_unit:
        notes.append(message("part-without-unit", size=size_text(mesh), unit=name))
    return Part(
        mesh,
        read.form,
        name,
        has_unit,
        bool((mesh.edges.counts == 2).all()),
        bodies,
        tuple(notes),
    )


def size_text(mesh: PartMesh) -> Message:
    """Its size along the axes."""
    x, y, z = (rounded(float(side), "", 5) for side in mesh.size_mm)
    return message("part-size", x=x, y=y, z=replace(z, unit="mm"))


def _open_note(mesh: PartMesh, open_edges: np.ndarray[tuple[int], np.dtype[np.int64]]) -> Text:
    ends = mesh.vertices_mm[mesh.edges.ends[open_edges]]
    longest = np.argsort(-np.linalg.norm(ends[:, 1] - ends[:, 0], axis=1), kind="stable")
    middles = ends.mean(axis=1)[longest[:NAMED_EDGES]]
    places = [
        message("part-place", x=quantity(x, "", 2), y=quantity(y, "", 2), z=quantity(z, "mm", 2))
        for x, y, z in middles
    ]
    return message("part-surface-open", count=len(open_edges), places=join(places, "; "))
