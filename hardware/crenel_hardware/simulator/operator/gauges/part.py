"""An example part with its inspection program, which the simulated operator touches; it is not
rendered. As truly made it differs from its drawing."""

from collections.abc import Callable, Iterable
from contextlib import suppress
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from crenel_hardware.simulator.devices.kinematics import (
    Floats,
    UnreachableError,
    rotation_about,
    translation,
)
from crenel_hardware.simulator.operator.gauge_operator import GaugeOperator
from crenel_hardware.simulator.operator.on_sphere import path_onto_place
from crenel_hardware.simulator.scene.datasheets import JsonObject

Touch = tuple[Floats, Floats]
"""A place (3,) on the surface and the normal (3,) out of the material, part frame."""
Box = tuple[tuple[float, float, float], tuple[float, float, float]]
PART_PLACE = translation(600.0, 30.0, 4.0) @ rotation_about("z", 0.12) @ rotation_about("x", 0.01)
"""``T_arm_part`` (4, 4)."""
GOLDEN = np.array([0.7548776662466927, 0.5698402909980532])
TURN = 0.381966
LEANS = (0.35, 0.1, 0.8)
"""How much of a normal a stylus leans by from the vertical, tried in turn."""


@dataclass(frozen=True)
class ExamplePart:
    """A plate with two bores, a pin, a ball, a step, a slot and a countersink; mm."""

    width: float = 90.0
    depth: float = 60.0
    top: float = 20.0
    step: float = 5.0
    """Height over the top."""
    bores: tuple[tuple[float, float, float], ...] = ((15.0, 15.0, 12.0), (15.0, 45.0, 12.0))
    """x, y, diameter."""
    pin: tuple[float, float, float, float] = (40.0, 30.0, 20.0, 12.0)
    """x, y, diameter, height over the top."""
    ball: tuple[float, float, float, float] = (70.0, 40.0, 32.0, 20.0)
    """x, y, z, diameter."""
    slot: tuple[float, float, float, float] = (40.0, 50.0, 8.0, 24.0)
    """x, y, width, overall length along x."""
    sink: tuple[float, float, float] = (38.0, 9.0, 6.0)
    """x, y, radius at the top; a cone of 45°."""

    @property
    def faces(self) -> dict[str, tuple[tuple[float, float, float], tuple[Box, ...]]]:
        """Normals of the planes, and rectangles of them that are free."""
        w, d, t, up = self.width, self.depth, self.top, self.top + self.step
        low = 6.0
        return {
            "A": (
                (0, 0, 1),
                (
                    ((24, 2, t), (30, 58, t)),
                    ((3, 24, t), (12, 36, t)),
                    ((54, 20, t), (88, 26, t)),
                    ((84, 30, t), (88, 57, t)),
                ),
            ),
            "B": ((0, -1, 0), (((3, 0, low), (w - 3, 0, t - 3)),)),
            "C": ((-1, 0, 0), (((0, 3, low), (0, d - 3, t - 3)),)),
            "D": ((1, 0, 0), (((w, 3, low), (w, d - 3, t - 3)),)),
            "E": ((0, 1, 0), (((3, d, low), (w - 3, d, t - 3)),)),
            "S": ((0, 0, 1), (((56, 4, up), (84, 14, up)),)),
        }

    def touch(self, feature: str, index: int) -> Touch:
        """The ``index``-th place of a feature.

        Raises:
            KeyError: the part has no such feature.
        """
        if feature in self.faces:
            return self._on_face(feature, index)
        turn = 2 * np.pi * TURN * index
        out = np.array([np.cos(turn), np.sin(turn), 0.0])
        ways: dict[str, Callable[[], Touch]] = {
            "H1": lambda: self._in_bore(0, index, out),
            "H2": lambda: self._in_bore(1, index, out),
            "pin": lambda: self._on_pin(index, out),
            "ball": lambda: self._on_ball(index, out),
            "slot": lambda: self._in_slot(index),
            "sink": lambda: self._in_sink(index, out),
        }
        return ways[feature]()

    def _on_face(self, feature: str, index: int) -> Touch:
        normal, boxes = self.faces[feature]
        low, high = (np.array(corner) for corner in boxes[index % len(boxes)])
        even = (0.5 + GOLDEN * (index + 1)) % 1.0
        place, free = low.astype(float), np.flatnonzero(np.array(normal) == 0)
        place[free] += even * (high - low)[free]
        return place, np.array(normal, dtype=float)

    def _in_bore(self, number: int, index: int, out: Floats) -> Touch:
        x, y, diameter = self.bores[number]
        level = self.top - (2.0 if index % 2 else 7.0)
        return np.array([x, y, level]) + diameter / 2 * out, -out

    def _on_pin(self, index: int, out: Floats) -> Touch:
        x, y, diameter, height = self.pin
        level = self.top + (3.0 if index % 2 else height - 3.0)
        return np.array([x, y, level]) + diameter / 2 * out, out

    def _on_ball(self, index: int, out: Floats) -> Touch:
        x, y, z, diameter = self.ball
        up = 1.0 - 0.9 * ((index * 0.618034) % 1.0)
        normal = np.sqrt(1 - up**2) * out + np.array([0.0, 0.0, up])
        return np.array([x, y, z]) + diameter / 2 * normal, normal

    def _in_slot(self, index: int) -> Touch:
        x, y, width, length = self.slot
        run = (length - width) / 2
        level = self.top - (1.5 if index // 2 % 2 else 4.5)
        if index % 3 == 2:  # an end
            side = 1.0 if index % 2 else -1.0
            turn = 0.9 * np.sin(1.7 * index)
            out = np.array([side * np.cos(turn), np.sin(turn), 0.0])
            return np.array([x + side * run, y, level]) + width / 2 * out, -out
        out = np.array([0.0, 1.0 if index % 2 else -1.0, 0.0])
        along = run * (2 * ((index * 0.618034) % 1.0) - 1)
        return np.array([x + along, y, level]) + width / 2 * out, -out

    def _in_sink(self, index: int, out: Floats) -> Touch:
        x, y, radius = self.sink
        at = radius - (0.7, 1.6, 2.5)[index % 3]
        place = np.array([x, y, self.top - radius + at]) + at * out
        normal = (np.array([0.0, 0.0, 1.0]) - out) / np.sqrt(2.0)
        return place, normal


DRAWING = ExamplePart()
MADE = ExamplePart(
    width=90.1,
    step=5.02,
    bores=((15.03, 14.98, 12.02), (15.05, 45.06, 12.4)),
    pin=(40.0, 30.02, 19.97, 12.0),
    slot=(40.02, 50.0, 8.03, 24.05),
)
"""The second bore is too wide, the width is at its limit."""


def example_program() -> JsonObject:
    """The file of the part's program: what its drawing wants."""
    return {
        "format": "crenel/inspection-program",
        "version": 1,
        "name": "Example plate",
        "part": {"name": "Example plate", "drawing": "TWIN-P1"},
        "features": list(_features(DRAWING)),
        "alignment": {
            "kind": "datums",
            "primary": "A",
            "secondary": "B",
            "tertiary": "C",
            "by": "touch",
        },
        "dimensions": list(_dimensions(DRAWING)),
        "source": {"default": "touch"},
    }


def _features(part: ExamplePart) -> Iterable[JsonObject]:
    for name, (normal, boxes) in part.faces.items():
        low, high = (np.array(corner, dtype=float) for corner in boxes[0])
        grown = [
            [[float(v) - 1.0 for v in box[0]], [float(v) + 1.0 for v in box[1]]] for box in boxes
        ]
        nominal = {"point_mm": ((low + high) / 2).tolist(), "normal": list(normal)}
        yield {"id": name, "kind": "plane", "nominal": nominal, "region": {"boxes_mm": grown}}
    up, top = [0, 0, 1], part.top
    for number, (x, y, diameter) in enumerate(part.bores, 1):
        nominal = {"point_mm": [x, y, top], "direction": up, "diameter_mm": diameter}
        length = {"length_mm": [-9.0, -0.5]}
        yield {
            "id": f"H{number}",
            "kind": "cylinder",
            "internal": True,
            "nominal": {**nominal, **length},
        }
    x, y, diameter, height = part.pin
    nominal = {"point_mm": [x, y, top], "direction": up, "diameter_mm": diameter}
    length = {"length_mm": [1.0, height - 0.5]}
    yield {"id": "pin", "kind": "cylinder", "nominal": {**nominal, **length}}
    *centre, diameter = part.ball
    yield {
        "id": "ball",
        "kind": "sphere",
        "nominal": {"centre_mm": list(centre), "diameter_mm": diameter},
    }
    x, y, width, overall = part.slot
    yield {
        "id": "slot",
        "kind": "slot",
        "nominal": {
            "centre_mm": [x, y, top],
            "direction": [1, 0, 0],
            "normal": up,
            "width_mm": width,
            "length_mm": overall,
            "depth_mm": [-6.0, -0.5],
        },
    }
    x, y, radius = part.sink
    yield {
        "id": "sink",
        "kind": "cone",
        "internal": True,
        "nominal": {
            "apex_mm": [x, y, top - radius],
            "direction": up,
            "half_angle_deg": 45.0,
            "length_mm": [1.5, radius - 0.2],
        },
    }


def _dimensions(part: ExamplePart) -> Iterable[JsonObject]:
    def one(
        name: str, kind: str, features: list[str], nominal: float, **more: object
    ) -> JsonObject:
        limits = {"nominal": nominal, "lower": -0.1, "upper": 0.1}
        return {"id": name, "kind": kind, "features": features, **limits, **more}

    yield one("width", "distance", ["C", "D"], part.width, along="x")
    yield one("depth", "distance", ["B", "E"], part.depth, along="y")
    yield one("step", "distance", ["A", "S"], part.step, along="z")
    for number, (x, y, diameter) in enumerate(part.bores, 1):
        yield one(f"d-H{number}", "diameter", [f"H{number}"], diameter)
        yield one(f"x-H{number}", "coordinate", [f"H{number}"], x, axis="x")
        yield one(f"y-H{number}", "coordinate", [f"H{number}"], y, axis="y")
    zone = {"id": "pos-H2", "kind": "position", "features": ["H2"], "datums": ["A", "B", "C"]}
    yield {**zone, "nominal": 0.0, "upper": 0.5}
    (x1, y1, _), (x2, y2, _) = part.bores
    yield one("H1-H2", "distance", ["H1", "H2"], float(np.hypot(x1 - x2, y1 - y2)))
    yield one("d-pin", "diameter", ["pin"], part.pin[2])
    yield one("d-ball", "diameter", ["ball"], part.ball[3])
    yield one("z-ball", "coordinate", ["ball"], part.ball[2], axis="z")
    yield one("w-slot", "width", ["slot"], part.slot[2])
    yield one("l-slot", "length", ["slot"], part.slot[3])
    angle = one("angle-sink", "half-angle", ["sink"], 45.0)
    yield {**angle, "lower": -1.0, "upper": 1.0, "unit": "deg"}


class PartOperator(GaugeOperator):
    """Touches the example part."""

    @cached_property
    def part(self) -> ExamplePart:
        """The part as truly made."""
        return MADE

    def touch_part(self, feature: str, index: int) -> bool:
        """Touches the ``index``-th place of a feature of the example part and presses the primary
        button; False when cancelled.

        Raises KeyError for a feature that it does not have, UnreachableError where the arm cannot
        get there.
        """
        place, normal = self.part.touch(feature, index)
        R, up = PART_PLACE[:3, :3], np.array([0.0, 0.0, 1.0])
        place, normal = R @ place + PART_PLACE[:3, 3], R @ normal
        with self._executor.move(f"touching the part's {feature}"):
            gap_mm = self.planner.gap_mm()
            for lean in LEANS:
                stylus = up + lean * normal
                with suppress(UnreachableError):
                    way = path_onto_place(
                        self._arm,
                        place,
                        gap_mm,
                        normal,
                        stylus / np.linalg.norm(stylus),
                        self.planner.current_joints(),
                        self._rng,
                    )
                    self._tap(lambda q, way=way: way)  # type: ignore[misc]
                    return True
            raise UnreachableError(f"the arm cannot touch the part's {feature} there")
        return False
