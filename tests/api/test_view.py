"""The 3D view's commands through the server: scans shown, renamed, deleted, colours, fits."""

import contextlib
import dataclasses
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from app.formats.clouds.files import cloud_writer
from app.formats.clouds.points import pack_points
from app.store.scans import ScanRecord
from tests.api.conftest import Server, run_command, wait_for
from tests.api.test_viewer import CAMERA, as_sent, viewer_socket
from tests.sent_texts import english

pytestmark = pytest.mark.device

KEY = "0123456789abcdef" * 2
# From above the middle of the plate: x to the right, y down, z ahead.
LOOK = dataclasses.replace(
    dataclasses.replace(CAMERA, near=0.01, far=50.0, image_width=900),
    wxyz=(0.0, 1.0, 0.0, 0.0),
    position=(0.5, 0.0, 0.3),
    look_at=(0.5, 0.0, 0.0),
)


@pytest.fixture
def scan(server: Server) -> Iterator[ScanRecord]:
    """A finished scan of a plate, 5 mm over the arm's zero."""
    folder = server.data / "scans" / "plate"
    folder.mkdir()
    xy = np.random.default_rng(1).uniform(-40, 40, (30_000, 2))
    off = np.random.default_rng(2).normal(0, 0.01, 30_000)
    points = np.column_stack([500 + xy[:, 0], xy[:, 1], 5 + off])
    ones = np.ones(30_000)
    with cloud_writer(folder / "cloud.ply") as writer:
        writer.append(pack_points(points, 80 * ones, 4 * ones, np.arange(30_000) // 300))
    record = ScanRecord("plate", "Plate", folder, "2026-11-21T10:00:00", 30_000, 100, 9.0, "c1")
    server.context.store.scans.add(record)
    server.context.scene.begin()  # what other tests have scanned is not in the picture
    yield record
    with contextlib.suppress(KeyError):
        server.http.delete("/api/scans/plate")


def view(server: Server) -> dict[str, Any]:
    return dict(server.http.get("/api/view").json())


def wait(server: Server, ready: Callable[[dict[str, Any]], bool]) -> dict[str, Any]:
    return wait_for(lambda: view(server), ready)


def show(server: Server) -> None:
    assert server.http.post("/api/scans/plate/shown", json={"on": True}).status_code == 200
    wait(server, lambda view: [scan["loaded"] for scan in view["scans"]] == [1.0])


def test_a_shown_scan_is_coloured_hidden_and_shown(server: Server, scan: ScanRecord) -> None:
    show(server)
    asked = {"measure": "intensity", "low": 0, "high": 160}
    legend = server.http.post("/api/view/colours", json=asked).json()["legend"]
    assert (legend["measure"], legend["automatic"]) == ("intensity", False)
    assert legend["unit"] == {"message_id": "grey-levels", "values": {}}
    assert len(legend["colours"]) == 17
    for wrong in ({"measure": "taste"}, {"measure": "age", "low": "a"}, {"low": 1, "high": 2}):
        assert server.http.post("/api/view/colours", json=wrong).status_code == 422
    refused = server.http.post("/api/view/colours", json={"measure": "deviation"})
    assert "no fitted shape" in refused.text
    server.http.post("/api/view/colours", json={"measure": "height"})
    assert not server.http.post("/api/scans/plate/shown", json={"on": False}).json()["scans"]
    assert server.http.post("/api/scans/none/shown", json={"on": True}).status_code == 404


def test_a_rectangle_is_fitted_as_its_page_looks_at_it(server: Server, scan: ScanRecord) -> None:
    show(server)
    region = {"view": KEY, "shape": "plane", "left": 0.4, "top": 0.4, "right": 0.6, "bottom": 0.6}
    assert "not connected" in server.http.post("/api/view/fits", json=region).text
    with viewer_socket(server, f"/viewer/{KEY}") as socket:
        socket.send(as_sent(LOOK))
        run_command(lambda: server.http.post("/api/view/fits", json=region))
    (fitted,) = wait(server, lambda view: bool(view["fits"]))["fits"]
    figures = {english(figure["label"]): figure for figure in fitted["figures"]}
    offset = figures["Distance from the arm's origin"]
    assert fitted["every"]
    assert offset["value"] == pytest.approx(5.0, abs=0.002)
    assert 0 < offset["uncertainty"] < 5.0
    assert fitted["rms_um"] == pytest.approx(10, rel=0.1)
    assert "not connected" in server.http.post("/api/view/fits", json=region).text
    assert not server.http.delete(f"/api/view/fits/{fitted['id']}").json()["fits"]
    assert server.http.post("/api/view/fits", json={**region, "left": 1.5}).status_code == 422


def test_a_scan_is_renamed_and_deleted_with_its_files(server: Server, scan: ScanRecord) -> None:
    def names() -> list[str]:
        return [found["name"] for found in server.http.get("/api/scans").json()]

    show(server)
    foreign = server.http.delete("/api/scans/plate", headers={"origin": "http://elsewhere"})
    assert (foreign.status_code, scan.folder.exists()) == (403, True)
    scan.folder.with_name(".deleted-before").mkdir()  # as a killed server leaves it
    before = view(server)["records"]
    assert server.http.post("/api/scans/plate/name", json={"name": " Cover  2 "}).status_code == 204
    assert "Cover 2" in names()
    assert server.http.post("/api/scans/plate/name", json={"name": "  "}).status_code >= 400
    assert server.http.delete("/api/scans/plate").status_code == 204
    assert "Cover 2" not in names()
    assert view(server)["records"] == before + 2
    assert not view(server)["scans"]
    assert not scan.folder.exists()
    assert not list(Path(scan.folder.parent).glob(".deleted-*"))
    assert server.http.delete("/api/scans/plate").status_code == 404
