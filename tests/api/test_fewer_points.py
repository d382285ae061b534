"""What a browser gets of the 3D view that cannot draw many points."""

import numpy as np
import pytest

from app.api.viewer.point_limit import PointLimiter
from app.api.viewer.proxy import KEY
from app.station.view3d.cloud_node import NODE_POINTS
from app.station.view3d.scene import Scene
from tests.station.conftest import until
from tests.station.test_scene import records, surface
from tests.station.viewer import Viewer

pytestmark = pytest.mark.device

MOST = 20_000


def large(viewer: Viewer) -> dict[str, np.ndarray]:
    """The nodes of one tier each."""
    return {name: points for name, points in viewer.clouds().items() if "-" in name}


def test_a_slow_browser_gets_an_even_picture_of_fewer_points_and_nothing_goes_wrong() -> None:
    scene = Scene(point_budget=400_000)
    fewer, all_of_it = Viewer(scene, PointLimiter(MOST).filter_frame), Viewer(scene)
    try:
        for seed in range(6):
            scene.add_points(records(surface(60_000, seed)))
            until(lambda: scene.waiting == 0)
        until(lambda: sum(map(len, all_of_it.listen(0.2).clouds().values())) == scene.points_shown)
        fewer.listen()
        assert scene.points_shown > 2 * NODE_POINTS
        assert MOST / 4 < sum(map(len, large(fewer).values())) <= MOST
        assert set(fewer.clouds()) < set(all_of_it.clouds())
        shown = np.concatenate(list(large(fewer).values()))
        cells = np.unique(np.floor(shown[:, :2] / 4).astype(int), axis=0)
        assert len(cells) >= 0.95 * 15 * 15
        (name, *_) = large(fewer)
        size, usual = (viewer.nodes[name]["props"]["point_size"] for viewer in (fewer, all_of_it))
        assert size > 2 * usual

        scene.colour_by("intensity", None)
        joined = Viewer(scene, PointLimiter(MOST).filter_frame)
        assert set(large(joined.listen())) <= set(large(fewer.listen()))
        joined.close()

        scene.begin()
        until(lambda: not fewer.listen(0.2).clouds())
        scene.add_points(records(surface(5_000)))
        until(lambda: sum(map(len, fewer.listen(0.2).clouds().values())) == scene.points_shown)
    finally:
        fewer.close()
        all_of_it.close()
        scene.close()


@pytest.mark.parametrize(
    ("key", "most"), [("ab" * 16, None), ("ab" * 16 + "-75", "75"), ("ab" * 16 + "-9999", "9999")]
)
def test_a_page_says_in_its_address_what_it_can_draw(key: str, most: str | None) -> None:
    known = KEY.fullmatch(key)
    assert known
    assert known[2] == most


@pytest.mark.parametrize("key", ["ab" * 16 + "-0", "ab" * 16 + "-", "ab" * 16 + "-x", "-75", "ab"])
def test_what_is_no_key_is_none(key: str) -> None:
    assert KEY.fullmatch(key) is None
