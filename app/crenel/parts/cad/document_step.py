"""STEP as triangles, in a process of its own: its library is large, and aborts on some files.

The process writes a line of JSON with the number of triangles of each body, then the corners of all
as doubles, mm. It prints what its library says on stderr.
"""

import json
import os
import subprocess
import sys
from collections.abc import Iterator
from contextlib import suppress
from importlib.util import find_spec
from pathlib import Path
from typing import Any

import numpy as np

from crenel.errors import OperationError
from crenel.formats.file_names import display_path
from crenel.messages.message import Text, message, quantity
from crenel.metrology.transforms import Floats
from crenel.parts.cad.document_triangles import MOST_TRIANGLES, Triangles

STARTED_MODULES = ("crenel.parts.cad.document_step",)
HEAD = b"ISO-10303-21"
MOST_MEMORY_BYTES = 2 << 30
MOST_SECONDS = 60
FINEST_MM, OF_TOLERANCE = 0.005, 1 / 20
"""Chord error of the triangles: this, or this share of the tolerance if it is less."""
OVERSHOOT = 2.5
"""By which the library's triangles may be farther from the surface than asked for."""
TURN_RAD = 0.3
"""Largest angle between facets of a curved surface."""


def is_step(head: bytes) -> bool:
    """Whether a file begins like a STEP file."""
    return head.lstrip().startswith(HEAD)


def read_step(path: Path, tolerance_mm: float | None = None) -> Triangles:
    """The surface of a STEP file as triangles, fine enough for a tolerance of this width.

    Raises:
        OperationError: ``extra-missing``; or it cannot be read within a minute and 2 GB.
    """
    if find_spec("OCP") is None:
        raise OperationError(
            "extra-missing",
            display_path(path),
            message("step-package-missing"),
            message("step-install-package", command="pip install 'crenel[cad]'"),
        )
    chord = FINEST_MM if tolerance_mm is None else min(FINEST_MM, tolerance_mm * OF_TOLERANCE)
    try:
        done = subprocess.run(
            [sys.executable, "-P", "-m", *STARTED_MODULES, str(path), repr(chord)],
            env=os.environ | {"OPENBLAS_NUM_THREADS": "1"},
            stdin=subprocess.DEVNULL,
            capture_output=True,
            check=False,
            timeout=MOST_SECONDS,
        )
    except subprocess.TimeoutExpired:
        raise _step_error(
            path, message("step-takes-too-long", most=quantity(MOST_SECONDS, "s"))
        ) from None
    if done.returncode:
        raise _step_error(path, message("step-cannot-be-read"))
    head, _, body = done.stdout.partition(b"\n")
    counts = json.loads(head)
    corners = np.frombuffer(body).reshape(-1, 3, 3)
    if not len(corners):
        raise _step_error(path, message("step-without-surface"))
    body_of = np.repeat(np.arange(len(counts), dtype=np.int32), counts)
    return Triangles(corners, "STEP", 1.0, body_of)


def _step_error(path: Path, why: Text) -> OperationError:
    return OperationError("step-unreadable", display_path(path), why, message("step-export-again"))


def _main(path: str, chord_mm: float) -> int:
    """Writes the triangles of a file to stdout; returns the exit status."""
    with suppress(ImportError):  # Windows limits no memory
        import resource

        resource.setrlimit(resource.RLIMIT_CPU, (MOST_SECONDS, MOST_SECONDS))
        _, most = resource.getrlimit(resource.RLIMIT_AS)
        limit = MOST_MEMORY_BYTES if most < 0 else min(MOST_MEMORY_BYTES, most)
        resource.setrlimit(resource.RLIMIT_AS, (limit, most))
    output = os.fdopen(os.dup(sys.stdout.fileno()), "wb")
    os.dup2(sys.stderr.fileno(), sys.stdout.fileno())  # on which the library prints
    pieces = list(_bodies(path, chord_mm))
    if sum(map(len, pieces)) > MOST_TRIANGLES:
        return 1
    output.write(json.dumps([len(piece) for piece in pieces]).encode() + b"\n")
    for piece in pieces:
        output.write(np.ascontiguousarray(piece).tobytes())
    output.close()
    return 0


def _bodies(path: str, chord_mm: float) -> Iterator[Floats]:
    """(T, 3, 3) corners of each body; of a file without bodies, of all its faces."""
    from OCP.BRepMesh import BRepMesh_IncrementalMesh
    from OCP.IFSelect import IFSelect_ReturnStatus
    from OCP.STEPControl import STEPControl_Reader
    from OCP.TopAbs import TopAbs_ShapeEnum

    reader = STEPControl_Reader()
    if reader.ReadFile(path) != IFSelect_ReturnStatus.IFSelect_RetDone:
        raise ValueError("it is not read")
    reader.TransferRoots()
    shape = reader.OneShape()
    BRepMesh_IncrementalMesh(shape, chord_mm / OVERSHOOT, False, TURN_RAD, False)
    bodies = list(_parts(shape, TopAbs_ShapeEnum.TopAbs_SOLID)) or [shape]
    for body in bodies:
        faces = [_face_triangles(face) for face in _parts(body, TopAbs_ShapeEnum.TopAbs_FACE)]
        yield np.concatenate([np.zeros((0, 3, 3)), *faces])


def _parts(shape: Any, kind: Any) -> Iterator[Any]:
    from OCP.TopExp import TopExp_Explorer

    explorer = TopExp_Explorer(shape, kind)
    while explorer.More():
        yield explorer.Current()
        explorer.Next()


def _face_triangles(face: Any) -> Floats:
    """(T, 3, 3) of a face with its triangles."""
    from OCP.BRep import BRep_Tool
    from OCP.TopAbs import TopAbs_Orientation
    from OCP.TopLoc import TopLoc_Location
    from OCP.TopoDS import TopoDS

    place = TopLoc_Location()
    mesh = BRep_Tool.Triangulation_s(TopoDS.Face(face), place)
    if mesh is None:
        return np.zeros((0, 3, 3))
    move = place.Transformation()
    nodes = np.array(
        [
            (point.X(), point.Y(), point.Z())
            for point in (mesh.Node(i + 1).Transformed(move) for i in range(mesh.NbNodes()))
        ]
    )
    numbers = [mesh.Triangle(i + 1) for i in range(mesh.NbTriangles())]
    corners = np.array([[one.Value(k) - 1 for k in (1, 2, 3)] for one in numbers])
    if face.Orientation() == TopAbs_Orientation.TopAbs_REVERSED:
        corners = corners[:, ::-1]
    return np.asarray(nodes[corners])


if __name__ == "__main__":
    sys.exit(_main(sys.argv[1], float(sys.argv[2])))
