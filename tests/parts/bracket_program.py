"""The program of the simulated bracket, the true values of its dimensions, and its touches."""

import json
from pathlib import Path

import numpy as np

from tests.parts.simulated_inspection import Floats
from tests.parts.simulated_solid import Bracket

Json = dict[str, object]


def bracket_features(part: Bracket) -> list[Json]:
    """Features of a bracket as its drawing has them."""
    w, h = part.size_mm
    z = part.top_mm
    x0, y0, x1, y1, rise = part.step
    bx, by, bd, bh = part.boss
    sx, sy, sz, sd = part.ball
    lx, ly, width, length, _ = part.slot
    cx, cy, angle, radius = part.cone
    features: list[Json] = [
        _plane(
            "A",
            (w / 2, h / 2, z),
            (0, 0, 1),
            [(24, 1, z - 1), (44, 25, z + 1)],
            [(72, 46, z - 1), (84, 79, z + 1)],
            [(25, 56, z - 1), (44, 79, z + 1)],
            [(92, 28, z - 1), (119, 38, z + 1)],
        ),
        _plane("B", (w / 2, 0, z / 2), (0, -1, 0), [(1, -1, 8), (w - 1, 1, z - 1)]),
        _plane("C", (0, h / 2, z / 2), (-1, 0, 0), [(-1, 1, 8), (1, h - 1, z - 1)]),
        _plane(
            "S",
            ((x0 + x1) / 2, (y0 + y1) / 2, z + rise),
            (0, 0, 1),
            [(x0 + 1, y0 + 1, z + rise - 1), (x1 - 1, y1 - 1, z + rise + 1)],
        ),
    ]
    for number, bore in enumerate(part.bores, 1):
        features.append(
            {
                "id": f"H{number}",
                "kind": "cylinder",
                "internal": True,
                "nominal": {
                    "point_mm": [bore.x_mm, bore.y_mm, z],
                    "direction": [0, 0, 1],
                    "diameter_mm": bore.diameter_mm,
                    "length_mm": [-8, -0.5],
                },
            }
        )
    features += [
        {
            "id": "boss",
            "kind": "cylinder",
            "nominal": {
                "point_mm": [bx, by, z],
                "direction": [0, 0, 1],
                "diameter_mm": bd,
                "length_mm": [1, bh - 0.5],
            },
        },
        {
            "id": "ball",
            "kind": "sphere",
            "nominal": {"centre_mm": [sx, sy, sz], "diameter_mm": sd},
            "region": {"boxes_mm": [[[sx - sd, sy - sd, z + 4], [sx + sd, sy + sd, sz + sd]]]},
        },
        {
            "id": "slot",
            "kind": "slot",
            "nominal": {
                "centre_mm": [lx, ly, z],
                "direction": [1, 0, 0],
                "normal": [0, 0, 1],
                "width_mm": width,
                "length_mm": length,
                "depth_mm": [-5, -0.5],
            },
        },
        {
            "id": "sink",
            "kind": "cone",
            "internal": True,
            "nominal": {
                "apex_mm": [cx, cy, z - radius / np.tan(np.radians(angle))],
                "direction": [0, 0, 1],
                "half_angle_deg": angle,
                "length_mm": [2, radius / np.tan(np.radians(angle)) - 0.5],
            },
        },
    ]
    return features


def _plane(
    name: str, point: tuple[float, ...], normal: tuple[float, ...], *boxes: list[tuple[float, ...]]
) -> Json:
    return {
        "id": name,
        "kind": "plane",
        "nominal": {"point_mm": list(point), "normal": list(normal)},
        "region": {"boxes_mm": [[list(low), list(high)] for low, high in boxes]},
    }


def bracket_dimensions(nominal: Bracket, true: Bracket) -> list[tuple[Json, float]]:
    """Dimensions with their limits, and the true value of each."""
    found: list[tuple[Json, float]] = []

    def add(
        name: str, kind: str, features: list[str], want: float, is_: float, **more: object
    ) -> None:
        limits = {"nominal": want, "lower": -0.05, "upper": 0.05, "unit": "mm"}
        found.append(({"id": name, "kind": kind, "features": features, **limits, **more}, is_))

    for number, (want, made) in enumerate(zip(nominal.bores, true.bores, strict=True), 1):
        name = f"H{number}"
        add(f"d-{name}", "diameter", [name], want.diameter_mm, made.diameter_mm)
        add(f"x-{name}", "coordinate", [name], want.x_mm, made.x_mm, axis="x")
        add(f"y-{name}", "coordinate", [name], want.y_mm, made.y_mm, axis="y")
        off = 2 * float(np.hypot(made.x_mm - want.x_mm, made.y_mm - want.y_mm))
        add(f"pos-{name}", "position", [name], 0.0, off, lower=None, upper=0.2)
    a, b = nominal.bores[:2], true.bores[:2]
    add(
        "H1-H2",
        "distance",
        ["H1", "H2"],
        float(np.hypot(a[0].x_mm - a[1].x_mm, a[0].y_mm - a[1].y_mm)),
        float(np.hypot(b[0].x_mm - b[1].x_mm, b[0].y_mm - b[1].y_mm)),
    )
    add("d-boss", "diameter", ["boss"], nominal.boss[2], true.boss[2])
    add("d-ball", "diameter", ["ball"], nominal.ball[3], true.ball[3])
    add("z-ball", "coordinate", ["ball"], nominal.ball[2], true.ball[2], axis="z")
    add("step", "distance", ["A", "S"], nominal.step[4], true.step[4], along="z")
    add("w-slot", "width", ["slot"], nominal.slot[2], true.slot[2])
    add("l-slot", "length", ["slot"], nominal.slot[3], true.slot[3])
    add("y-slot", "coordinate", ["slot"], nominal.slot[1], true.slot[1], axis="y")
    degrees = {"unit": "deg", "lower": -0.2, "upper": 0.2}
    add("angle-sink", "half-angle", ["sink"], nominal.cone[2], true.cone[2], **degrees)
    add(
        "boss-ball",
        "distance",
        ["boss", "ball"],
        0.0,
        0.0,
        along="x",
        nominal=nominal.ball[0] - nominal.boss[0],
    )
    found[-1] = (found[-1][0], true.ball[0] - true.boss[0])
    add("A-B", "angle", ["A", "B"], 90.0, 90.0, **degrees)
    return found


def write_program(
    path: Path,
    nominal: Bracket,
    true: Bracket,
    by: str = "scan",
    touch: tuple[str, ...] = (),
    both: tuple[str, ...] = (),
) -> None:
    dimensions = [
        {name: value for name, value in one.items() if value is not None}
        for one, _ in bracket_dimensions(nominal, true)
    ]
    program = {
        "format": "crenel/inspection-program",
        "version": 1,
        "name": "Bracket",
        "part": {"name": "Bracket", "unit": "mm"},
        "features": bracket_features(nominal),
        "alignment": {
            "kind": "datums",
            "primary": "A",
            "secondary": "B",
            "tertiary": "C",
            "by": by,
        },
        "dimensions": dimensions,
        "source": {"default": "scan", "touch": list(touch), "both": list(both)},
    }
    path.write_text(json.dumps(program))


def datum_touches(part: Bracket) -> dict[str, list[tuple[Floats, Floats]]]:
    """Touches of the three datums: places and outward normals."""
    z = part.top_mm
    up, front, left = np.array([0.0, 0, 1]), np.array([0.0, -1, 0]), np.array([-1.0, 0, 0])
    return {
        "A": [
            (np.array([x, y, z]), up)
            for x, y in ((30, 5), (40, 20), (78, 75), (30, 75), (115, 33), (75, 50), (100, 30))
        ],
        "B": [
            (np.array([x, 0.0, q]), front)
            for x, q in ((5, 15), (40, 12), (80, 16), (115, 14), (60, 15))
        ],
        "C": [(np.array([0.0, y, q]), left) for y, q in ((5, 15), (40, 12), (75, 14))],
    }


def bore_touches(part: Bracket, number: int = 0) -> list[tuple[Floats, Floats]]:
    """Twelve touches of a bore in two levels: places and normals out of the material."""
    bore, found = part.bores[number], []
    for level in (-2.0, -7.0):
        for turn in np.radians(np.arange(0, 360, 60) + 10 * level):
            inward = -np.array([np.cos(turn), np.sin(turn), 0.0])
            axis = np.array([bore.x_mm, bore.y_mm, part.top_mm + level])
            found.append((axis - inward * bore.diameter_mm / 2, inward))
    return found
