"""What loops are compiled on before the station opens."""

from app.metrology.detection.corners import detect_object
from app.station.warm_up import BLOCK, drawn_block


def test_the_search_comes_to_its_end_on_the_drawn_block() -> None:
    found = detect_object(drawn_block(), BLOCK)
    assert len(found.corners) >= 8
    assert found.rms_px < 0.3
