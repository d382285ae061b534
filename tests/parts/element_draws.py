"""Elements and dimensions that the panel measures, of many true stations, beside the truth."""

from collections.abc import Iterator
from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np

from crenel.parts.elements.evaluate_element import join_elements
from crenel.parts.elements.maths_figures import ElementFigure, element_figures
from crenel.parts.elements.maths_relations import relation_figures
from tests.parts.draws import Setting
from tests.parts.picks import Pick, scan_bracket
from tests.parts.simulated_solid import Bracket

Measured = dict[str, tuple[float, ElementFigure]]
"""By name: the true value, mm or rad, and the figure."""


def bracket_picks(part: Bracket) -> dict[str, Pick]:
    """Rectangles over the elements of a part, and beyond them, as a hurried operator draws them."""
    z = part.top_mm
    first, second, third = part.bores
    bx, by, bd, bh = part.boss
    sx, sy, sz, sd = part.ball
    x0, y0, x1, y1, height = part.step
    cx, cy, _, radius = part.cone
    picks = {
        f"bore{number}": Pick(
            "cylinder", (one.x_mm, one.y_mm, z - 4), (one.diameter_mm + 3, one.diameter_mm + 3)
        )
        for number, one in enumerate((first, second, third), 1)
    }
    return picks | {
        "boss": Pick("cylinder", (bx, by, z + bh / 2), (bd + 4, bd + 2), 50.0, 20.0),
        "ball": Pick("sphere", (sx, sy, sz + sd / 4), (sd + 3, sd + 3), 15.0),
        "step": Pick(
            "plane", ((x0 + x1) / 2, (y0 + y1) / 2, z + height), (x1 - x0 - 4, y1 - y0 - 3)
        ),
        "top": Pick("plane", ((x0 + x1) / 2, y1 + 5, z), (x1 - x0 - 4, 6.0)),
        "sink": Pick("cone", (cx, cy, z - radius / 2), (2 * radius + 2, 2 * radius + 2)),
    }


def measure_draw(setting: Setting, seed: int) -> Measured:
    """Picks the elements of one scan, and takes dimensions between them."""
    true = setting.true
    with TemporaryDirectory() as name:
        part = scan_bracket(Path(name), setting, seed)
        found = {key: part.measure(pick) for key, pick in bracket_picks(setting.nominal).items()}

    def own(name: str) -> ElementFigure:
        knowledge = found[name].knowledge
        assert knowledge is not None
        return element_figures(knowledge)[0]

    def between(first: str, second: str) -> ElementFigure:
        knowledge = join_elements([found[first], found[second]])
        assert knowledge is not None
        return relation_figures(knowledge)[0]

    bores = true.bores
    measured: Measured = {
        f"bore{number}": (one.diameter_mm, own(f"bore{number}"))
        for number, one in enumerate(bores, 1)
    }
    place = np.array([[one.x_mm, one.y_mm] for one in bores])
    bx, by, bd, _ = true.boss
    sx, sy, sz, sd = true.ball
    return measured | {
        "boss": (bd, own("boss")),
        "ball": (sd, own("ball")),
        "sink": (2 * np.radians(true.cone[2]), own("sink")),
        "bore1-bore2": (float(np.linalg.norm(place[1] - place[0])), between("bore1", "bore2")),
        "bore1-bore3": (float(np.linalg.norm(place[2] - place[0])), between("bore1", "bore3")),
        "step-top": (true.step[4], between("step", "top")),
        "ball-top": (sz - true.top_mm, between("ball", "top")),
        "ball-boss": (float(np.hypot(sx - bx, sy - by)), between("ball", "boss")),
        "bore1-top": (np.pi / 2, between("bore1", "top")),
    }


def pulls_of(draws: list[Measured]) -> Iterator[tuple[str, float, float, float]]:
    """Of each figure: claimed over observed, bias in u, and the rms of its errors."""
    for name in draws[0]:
        errors = np.array([one[name][1].value - one[name][0] for one in draws])
        claimed = np.array([one[name][1].standard_uncertainty for one in draws])
        rms = float(np.sqrt(np.mean(errors**2)))
        ratio = float(np.sqrt(np.mean(claimed**2))) / rms
        yield name, ratio, float(np.mean(errors / claimed)), rms
