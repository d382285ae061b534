"""A block as a solid of planar faces: STEP AP214 (ISO 10303-21 and -214), mm."""

from collections.abc import Sequence
from pathlib import Path

from crenel.formats.atomic_write import write_atomically
from crenel.metrology.targets.crenellated_block import Crenellated, outline_mm

SCHEMA = "AUTOMOTIVE_DESIGN { 1 0 10303 214 1 1 1 1 }"
ACCURACY_MM = 1e-6

Point = tuple[float, float, float]


def write_step(path: Path, block: Crenellated) -> None:
    """Writes the block in mm, in the object frame.

    Raises:
        OperationError: the file cannot be written.
    """
    entities = _Entities()
    shape = _representation(entities, _solid(entities, block), block.name)
    _product(entities, shape, block.name)
    text = "\n".join(
        [
            "ISO-10303-21;",
            "HEADER;",
            f"FILE_DESCRIPTION(({_text('Crenellated block, mm')}),'2;1');",
            f"FILE_NAME({_text(block.name)},'',(''),(''),'Crenel','','');",
            f"FILE_SCHEMA(('{SCHEMA}'));",
            "ENDSEC;",
            "DATA;",
            *entities.lines,
            "ENDSEC;",
            "END-ISO-10303-21;",
            "",
        ]
    )
    write_atomically(path, text.encode("ascii"))


class _Entities:
    """Lines of the data section, each with its number."""

    def __init__(self) -> None:
        self.lines: list[str] = []

    def add(self, content: str) -> str:
        """Adds an entity; returns the reference to it."""
        number = f"#{len(self.lines) + 1}"
        self.lines.append(f"{number}={content};")
        return number

    def point(self, at_mm: Point) -> str:
        return self.add(f"CARTESIAN_POINT('',({_numbers(at_mm)}))")

    def direction(self, along: Point) -> str:
        return self.add(f"DIRECTION('',({_numbers(along)}))")


def _solid(entities: _Entities, block: Crenellated) -> str:
    """The shell of the block: its front, its back, and a face between for each side."""
    outline = outline_mm(block)
    count, following = len(outline), [*outline[1:], outline[0]]
    ends = block.front_y_mm, block.back_y_mm
    points = [[(x, y, z) for x, z in outline] for y in ends]
    vertices = [
        [entities.add(f"VERTEX_POINT('',{entities.point(at)})") for at in row] for row in points
    ]

    def edge(first: tuple[int, int], second: tuple[int, int]) -> str:
        (a, i), (b, j) = first, second
        along = _unit(points[a][i], points[b][j])
        vector = entities.add(f"VECTOR('',{entities.direction(along)},1.)")
        line = entities.add(f"LINE('',{entities.point(points[a][i])},{vector})")
        return entities.add(f"EDGE_CURVE('',{vertices[a][i]},{vertices[b][j]},{line},.T.)")

    fronts, backs = (
        [edge((end, i), (end, (i + 1) % count)) for i in range(count)] for end in range(2)
    )
    sides = [edge((0, i), (1, i)) for i in range(count)]
    faces = [
        _face(entities, points[0][0], (0.0, -1.0, 0.0), [(one, True) for one in fronts]),
        _face(entities, points[1][0], (0.0, 1.0, 0.0), [(one, False) for one in reversed(backs)]),
    ]
    for i, ((ax, az), (bx, bz)) in enumerate(zip(outline, following, strict=True)):
        x, _, z = _unit((ax, 0.0, az), (bx, 0.0, bz))
        loop = [(sides[i], True), (backs[i], True), (sides[(i + 1) % count], False)]
        faces.append(_face(entities, points[0][i], (z, 0.0, -x), [*loop, (fronts[i], False)]))
    shell = entities.add(f"CLOSED_SHELL('',({','.join(faces)}))")
    return entities.add(f"MANIFOLD_SOLID_BREP('',{shell})")


def _face(
    entities: _Entities, at_mm: Point, normal: Point, loop: Sequence[tuple[str, bool]]
) -> str:
    """A face by a point, its outward normal, and its edges, anticlockwise as seen from outside."""
    across = (1.0, 0.0, 0.0) if normal[0] == 0.0 else (0.0, 1.0, 0.0)
    axes = f"{entities.direction(normal)},{entities.direction(across)}"
    placed = entities.add(f"AXIS2_PLACEMENT_3D('',{entities.point(at_mm)},{axes})")
    plane = entities.add(f"PLANE('',{placed})")
    edges = [
        entities.add(f"ORIENTED_EDGE('',*,*,{edge},{'.T.' if forward else '.F.'})")
        for edge, forward in loop
    ]
    bound = entities.add(f"EDGE_LOOP('',({','.join(edges)}))")
    outer = entities.add(f"FACE_OUTER_BOUND('',{bound},.T.)")
    return entities.add(f"ADVANCED_FACE('',({outer}),{plane},.T.)")


def _representation(entities: _Entities, solid: str, name: str) -> str:
    """The solid in mm, radians and steradians."""
    mm = entities.add("(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.MILLI.,.METRE.))")
    rad = entities.add("(NAMED_UNIT(*)PLANE_ANGLE_UNIT()SI_UNIT($,.RADIAN.))")
    sr = entities.add("(NAMED_UNIT(*)SI_UNIT($,.STERADIAN.)SOLID_ANGLE_UNIT())")
    least = f"LENGTH_MEASURE({_numbers([ACCURACY_MM])})"
    off = entities.add(f"UNCERTAINTY_MEASURE_WITH_UNIT({least},{mm},'distance_accuracy_value','')")
    context = entities.add(
        "(GEOMETRIC_REPRESENTATION_CONTEXT(3)"
        f"GLOBAL_UNCERTAINTY_ASSIGNED_CONTEXT(({off}))"
        f"GLOBAL_UNIT_ASSIGNED_CONTEXT(({mm},{rad},{sr}))REPRESENTATION_CONTEXT('',''))"
    )
    return entities.add(f"ADVANCED_BREP_SHAPE_REPRESENTATION({_text(name)},({solid}),{context})")


def _product(entities: _Entities, shape: str, name: str) -> None:
    """The product of which the representation is the shape."""
    about = entities.add("APPLICATION_CONTEXT('automotive design')")
    standard = "'international standard','automotive_design',2000"
    entities.add(f"APPLICATION_PROTOCOL_DEFINITION({standard},{about})")
    context = entities.add(f"PRODUCT_CONTEXT('',{about},'mechanical')")
    product = entities.add(f"PRODUCT({_text(name)},{_text(name)},'',({context}))")
    entities.add(f"PRODUCT_RELATED_PRODUCT_CATEGORY('part',$,({product}))")
    version = entities.add(f"PRODUCT_DEFINITION_FORMATION('','',{product})")
    stage = entities.add(f"PRODUCT_DEFINITION_CONTEXT('part definition',{about},'design')")
    definition = entities.add(f"PRODUCT_DEFINITION('design','',{version},{stage})")
    shaped = entities.add(f"PRODUCT_DEFINITION_SHAPE('','',{definition})")
    entities.add(f"SHAPE_DEFINITION_REPRESENTATION({shaped},{shape})")


def _unit(start: Point, end: Point) -> Point:
    """From one point towards another along an axis."""
    x, y, z = (float((b > a) - (b < a)) for a, b in zip(start, end, strict=True))
    return x, y, z


def _numbers(values: Sequence[float]) -> str:
    """Reals of ISO 10303-21, which have a decimal point."""
    return ",".join(f"{value + 0.0:.6f}" for value in values)


def _text(words: str) -> str:
    """A string of ISO 10303-21."""
    plain = words.replace("\\", "\\\\").replace("'", "''")
    return "'" + "".join(c if " " <= c <= "~" else _escape(c) for c in plain) + "'"


def _escape(character: str) -> str:
    return f"\\X4\\{ord(character):08X}\\X0\\"
