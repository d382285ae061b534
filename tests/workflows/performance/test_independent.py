"""The figures of a one-sphere test against an independent computation from the same files."""

import ast
from pathlib import Path

import pytest

from app.bench.metrology.rendered_sphere import RenderedStation
from app.bench.metrology.synthetic_sphere import PlantedFaults
from app.workflows.performance.evaluate import write_performance
from tests.workflows.performance import independent_figures
from tests.workflows.performance.independent_figures import independent_figures_um

WITHIN_UM = 0.1


@pytest.fixture(scope="module")
def station() -> RenderedStation:
    return RenderedStation(width_px=640, height_px=512, frames=40, seed=3)


@pytest.mark.parametrize(
    "faults",
    [
        PlantedFaults(),
        PlantedFaults(matrix_offset_mm=(0.03, -0.05, 0.02), outliers=0.03, link_mm=0.05),
    ],
    ids=["as it should be", "with faults"],
)
def test_every_figure_agrees(
    station: RenderedStation, tmp_path: Path, faults: PlantedFaults
) -> None:
    folder = station.write(tmp_path / "test", faults)
    result = write_performance(folder)
    values = {one.quantity: one.value for one in result.figures}
    independent_um = independent_figures_um(folder)
    assert set(values) == set(independent_um)
    assert None not in values.values()
    assert values == pytest.approx(independent_um, abs=WITHIN_UM)


def test_the_computation_uses_nothing_of_the_evaluation() -> None:
    tree = ast.parse(Path(independent_figures.__file__).read_text())
    imported = [node.module or "" for node in ast.walk(tree) if isinstance(node, ast.ImportFrom)]
    assert not [name for name in imported if name.startswith(("app.metrology", "app.workflows"))]
