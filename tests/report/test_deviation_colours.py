"""Deviations have one scale and one meaning of the colours in every drawing and page."""

import json
from collections.abc import Sequence
from pathlib import Path

import numpy as np
import pytest

from crenel.gauges.quick.evaluate_deviation_maps import MAP, MapFile, read_maps, scale_end_um
from crenel.gauges.quick.report_figures import deviation_figure
from crenel.gauges.sphere.report_figures import hemisphere_figure
from crenel.messages.message import Text
from crenel.metrology.colormaps import BALANCE, scale_stops
from crenel.report.contents.residual_figures import object_figure
from crenel.report.figure import Dot, Figure, Polyline
from crenel.station.view3d.cloud_colouring import MEASURE_SCALES
from tests.formats.builders import BLOCK

STOPS = Path(__file__).parents[2] / "frontend/src/controls/deviationStops.json"


def drawn_colours(figure: Figure[Text]) -> set[str]:
    """Of dots and faces, other than greys."""
    found = {item.fill for item in figure.items if isinstance(item, Dot | Polyline)}
    return {fill for fill in found if fill and abs(redness(fill)) > 24}


def redness(colour: str) -> int:
    return int(colour[1:3], 16) - int(colour[5:7], 16)


def map_figure(deviation_um: float) -> Figure[Text]:
    cells = MapFile(cell_mm=1, x_mm=(0,), y_mm=(0,), deviation_um=(deviation_um,))
    figure, _ = deviation_figure("Cloud 1", cells, 10.0)
    figure.items = figure.items[:2]  # without its legend
    return figure


def touched_figure(deviation_um: float) -> Figure[Text]:
    point = np.array([[1.0, 1.0, BLOCK.crest_z_mm]])
    return object_figure(BLOCK, ["crest"], point, [deviation_um], [])[0]


def sphere_figure(deviation_um: float) -> Figure[Text]:
    return hemisphere_figure([deviation_um], "touched")[0]


@pytest.mark.parametrize("draw", [map_figure, touched_figure, sphere_figure])
def test_blue_is_inside_and_orange_outside(draw: object) -> None:
    assert callable(draw)
    for deviation_um, sign in ((8.0, 1), (-8.0, -1)):
        colours = drawn_colours(draw(deviation_um))
        assert colours
        assert all(redness(colour) * sign > 0 for colour in colours), (deviation_um, colours)


def test_the_browser_has_the_scale_of_reports_and_of_the_3d_view() -> None:
    assert json.loads(STOPS.read_text()) == list(scale_stops(BALANCE))
    assert MEASURE_SCALES["deviation"].scale is BALANCE


@pytest.mark.parametrize(
    ("clouds", "end_um"),
    [
        ([[0.1]], 5.0),
        ([[4.0] * 99 + [400.0], [-13.0] * 100], 20.0),
        ([[-51.0], [3.0]], 100.0),
        ([[4e5]], 1000.0),
        ([[]], 5.0),
    ],
)
def test_clouds_share_one_round_scale(
    tmp_path: Path, clouds: Sequence[Sequence[float]], end_um: float
) -> None:
    for number, off_um in enumerate(clouds):
        axis = tuple(float(i) for i in range(len(off_um)))
        folder = tmp_path / str(number)
        folder.mkdir()
        cells = MapFile(cell_mm=1, x_mm=axis, y_mm=axis, deviation_um=tuple(off_um))
        cells.write(folder / MAP)
    maps = read_maps([*sorted(tmp_path.iterdir()), tmp_path / "nowhere"])
    assert len(maps) == len(clouds)
    assert scale_end_um([*maps.values()]) == end_um
