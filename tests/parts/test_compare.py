"""A finished scan is compared with a part through the station, and the map is kept with it."""

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import httpx
import numpy as np
import pytest

from crenel.parts.compare.document_comparison import COMPARISON
from crenel.parts.deviation.document_map import CELL, rows_of_map
from crenel.store.scans import ScanRecord
from tests.api.conftest import Server, code_of, running_server, wait_for
from tests.parts.meshes import box_corners, stl_bytes, stl_text
from tests.parts.plate_scans import PLATE, add_plate_scan, forget_covariance
from tests.sent_texts import english

pytestmark = pytest.mark.device
PIECE = 200_000
TOLERANCE = {"lower_mm": -0.04, "upper_mm": 0.04}
CUBE = box_corners(np.array([30.0, 20.0, 10.0]))


@pytest.fixture(scope="module")
def server(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Server]:
    with running_server(tmp_path_factory.mktemp("station")) as server:
        yield server
    assert not server.sent.untranslated()


@pytest.fixture(scope="module")
def scan(server: Server) -> ScanRecord:
    return add_plate_scan(server.context.store, "plate")


def send(http: httpx.Client, name: str, content: bytes) -> httpx.Response:
    """Sends a file in pieces; the answer to the last of them, or to the first that is refused."""
    answer = http.post("/api/cad", json={"name": name, "size": len(content)})
    if answer.status_code != 200:
        return answer
    part = answer.json()["id"]
    for at in range(0, len(content), PIECE):
        piece = content[at : at + PIECE]
        answer = http.put(f"/api/cad/{part}/file", params={"at": at}, content=piece)
        answer.raise_for_status()
    return answer


def state(server: Server) -> dict[str, Any]:
    return dict(server.http.get("/api/cad").json())


def keep(server: Server, name: str, content: bytes) -> dict[str, Any]:
    """The part of a file that is read."""
    send(server.http, name, content).raise_for_status()
    found = wait_for(lambda: state(server), lambda state: state["reading"] is None)
    assert found["refused"] is None, found["refused"]
    return dict(found["parts"][0])


def refusal_of(server: Server, name: str, content: bytes) -> str:
    """Why a file is refused, at once or after it was read; nothing is left of it."""
    before = state(server)["parts"]
    answer = send(server.http, name, content)
    if answer.status_code == 422:
        body = answer.json()
        said = f"{body['detail']} {body['remedy']}"
    else:
        found = wait_for(lambda: state(server), lambda state: state["reading"] is None)
        assert found["refused"] is not None, found["parts"]
        assert found["refused"]["name"] == name
        said = english(found["refused"]["text"])
    assert state(server)["parts"] == before
    folder = server.data / "parts"
    kept = {one["id"] for one in before}
    assert {one.name for one in folder.iterdir()} == kept if folder.exists() else not kept
    assert "Traceback" not in said
    assert "\n" not in said
    assert str(server.data) not in said
    return said


def compare(server: Server, part: str, unit: str = "mm", **other: Any) -> dict[str, Any]:
    """Compares the scan, and waits for what comes of it."""
    wish = {"part": part, "unit": unit, **TOLERANCE, **other}
    answer = server.http.post("/api/scans/plate/deviation", json=wish)
    assert answer.status_code == 202, answer.text
    return wait_for(lambda: state(server), lambda state: state["running"] is None)


def test_a_file_without_a_unit_asks_for_it(server: Server, scan: ScanRecord) -> None:
    part = keep(server, "C:\\drawings\\plate.stl", stl_bytes(PLATE.corners()))
    assert part["name"] == "plate.stl"
    assert not part["has_unit"]
    assert part["unit"] == ""
    assert part["size"] == pytest.approx([*PLATE.size_mm, PLATE.top_mm + PLATE.rib[-1]])
    wish = {"part": part["id"], **TOLERANCE}
    answer = server.http.post("/api/scans/plate/deviation", json=wish)
    assert code_of(answer) == (422, "part-without-unit")
    server.http.post("/api/scans/plate/shown", json={"on": True}).raise_for_status()
    wait_for(
        lambda: server.http.get("/api/view").json(),
        lambda view: [one["loaded"] for one in view["scans"]] == [1.0],
    )
    extents = server.http.get("/api/scans/plate/size").json()["mm"]
    assert extents[0] == pytest.approx(max(PLATE.size_mm), rel=0.15)


def test_a_scan_is_compared_shown_downloaded_and_removed(server: Server, scan: ScanRecord) -> None:
    part = keep(server, "plate.stl", stl_bytes(PLATE.corners()))
    assert len(state(server)["parts"]) == 1  # in place of that of the same name
    found = compare(server, part["id"])
    assert found["refused"] is None, found["refused"]
    shown = found["shown"]
    assert shown["legend"]["mode"] == "significance"
    assert server.http.get("/api/view").json()["surface_of"] == "plate"
    result = server.http.get("/api/scans/plate/deviation").json()
    assert result["uncertainty"] == "full"
    assert result["profile"]["decision"] == "fail"  # a bump of 150 µm
    assert result["residual_um"] < 30
    assert state(server)["parts"][0]["upper_mm"] == 0.04
    rows = rows_of_map(server.http.get("/api/scans/plate/map.ply").content)
    assert rows.dtype == CELL
    counts = result["counts"]
    assert [int(np.sum(rows["decision"] == one)) for one in (0, 1, 2)] == [
        counts["inside"],
        counts["outside"],
        counts["undecided"],
    ]
    assert min(counts.values()) > 0
    saved = server.http.get("/api/scans/plate/deviation.json").json()
    assert saved["format"] == "crenel/deviation"
    assert saved["counts"] == counts
    for mode in ("deviation", "uncertainty"):
        body = {"on": True, "mode": mode}
        legend = server.http.post("/api/scans/plate/deviation/shown", json=body).json()["shown"][
            "legend"
        ]
        assert len(legend["colours"]) > 2
        assert mode == "uncertainty" or legend["high_um"] == -legend["low_um"] == 80
    server.http.post("/api/scans/plate/deviation/shown", json={"on": False}).raise_for_status()
    assert server.http.get("/api/view").json()["surface_of"] == ""
    server.http.delete("/api/scans/plate/deviation").raise_for_status()
    assert server.http.get("/api/scans/plate/deviation").json() is None
    again = server.http.post("/api/scans/plate/deviation/shown", json={"on": True})
    assert again.status_code == 404
    assert not (scan.folder / COMPARISON).exists()


def test_what_is_cancelled_leaves_what_was(server: Server, scan: ScanRecord) -> None:
    part = keep(server, "plate.stl", stl_bytes(PLATE.corners()))
    compare(server, part["id"])
    before = (scan.folder / COMPARISON).read_bytes()
    wish = {"part": part["id"], "unit": "mm", "lower_mm": -0.5, "upper_mm": 0.5}
    server.http.post("/api/scans/plate/deviation", json=wish).raise_for_status()
    again = server.http.post("/api/scans/plate/deviation", json=wish)
    assert code_of(again) == (422, "busy")
    assert server.http.post("/api/comparison/cancel").json()["running"]["is_cancelled"]
    found = wait_for(lambda: state(server), lambda state: state["running"] is None)
    assert found["refused"] is None
    assert (scan.folder / COMPARISON).read_bytes() == before
    assert {one.name for one in scan.folder.iterdir()} >= {COMPARISON, "scan.mcap", "cloud.ply"}
    assert not list(scan.folder.glob(".*"))


def test_a_part_of_another_size_or_shape_is_refused(server: Server, scan: ScanRecord) -> None:
    part = keep(server, "plate.stl", stl_bytes(PLATE.corners()))
    found = compare(server, part["id"], "inch")
    assert "State mm as the unit" in english(found["refused"]["text"]) or "does not fit" in english(
        found["refused"]["text"]
    )
    plate = PLATE.corners()
    mirrored = (plate * [-1.0, 1.0, 1.0])[:, ::-1]
    other = keep(server, "mirrored.stl", stl_bytes(np.ascontiguousarray(mirrored)))
    found = compare(server, other["id"])
    assert "mirror" in english(found["refused"]["text"])
    server.http.delete(f"/api/cad/{other['id']}").raise_for_status()
    assert [one["name"] for one in state(server)["parts"]] == ["plate.stl"]


@pytest.mark.parametrize(
    ("name", "content", "said"),
    [
        ("part.obj", b"v 0 0 0", "it is no part in a known format. Give a .stl"),
        ("empty.stl", b"", "it is empty"),
        ("cut.stl", stl_bytes(CUBE)[:-30], "part.stl"),
        ("cut.stl", stl_bytes(CUBE)[:-30], "contains 11 of 12 triangles"),
        ("huge.stl", stl_bytes(CUBE, announced=2**32 - 1), "contains 12 of 4294967295 triangles"),
        ("commas.stl", stl_text(CUBE).replace(".", ",").encode(), "line 4 have decimal commas"),
        ("far.stl", stl_bytes(CUBE * 1e11), "far.stl"),
        ("flat.stl", stl_bytes(CUBE * [1.0, 0.0, 0.0]), "it has no triangle with an area"),
        ("page.step", b"<html><body>404</body></html>", "it is not a part in a known format"),
        ("page.stl", b"<html><body>404</body></html>", "it is not a part in a known format"),
        ("broken.step", b"ISO-10303-21;\nHEADER;\n#1=A(#1);", "broken.step"),
    ],
)
def test_a_bad_file_is_refused_with_one_line(
    server: Server, name: str, content: bytes, said: str
) -> None:
    line = refusal_of(server, name, content)
    if said == "part.stl":  # the station's own name of it is none of its user's
        assert said not in line
    else:
        assert said in line.replace("\N{NO-BREAK SPACE}", " "), line


@pytest.mark.parametrize(
    ("content", "said"),
    [
        (stl_bytes(np.ascontiguousarray(CUBE[:, ::-1])), "All triangles faced inwards"),
        (stl_bytes(CUBE[2:]), "Its surface is open"),
        (stl_bytes(CUBE, head=b"solid a part".ljust(80)), ""),
        (stl_bytes(np.concatenate([CUBE, CUBE[:1] * 0 + 1])), "has no area, and is left out"),
        (stl_bytes(np.concatenate([CUBE, CUBE[:1] * np.nan])), "no number, and is left out"),
        (stl_text(CUBE).encode(), ""),
    ],
)
def test_a_doubtful_file_is_kept_with_what_was_found(
    server: Server, content: bytes, said: str
) -> None:
    part = keep(server, "doubtful.stl", content)
    notes = [english(one) for one in part["notes"]]
    assert any(said in one for one in notes) if said else not notes
    server.http.delete(f"/api/cad/{part['id']}").raise_for_status()


def test_pieces_come_in_order(server: Server) -> None:
    content = stl_bytes(CUBE)
    asked = {"name": "cube.stl", "size": len(content)}
    part = server.http.post("/api/cad", json=asked).json()["id"]
    late = server.http.put(f"/api/cad/{part}/file", params={"at": 5}, content=content[5:])
    assert code_of(late) == (422, "wrong-piece")
    other = server.http.put("/api/cad/other/file", params={"at": 0}, content=content)
    assert code_of(other) == (422, "no-upload")
    too_large = server.http.post("/api/cad", json={"name": "a.stl", "size": 10**9})
    assert code_of(too_large) == (422, "part-not-taken")
    assert keep(server, "cube.stl", content)["triangles"] == 12


def test_scatter_alone_decides_nothing(server: Server, scan: ScanRecord) -> None:
    forget_covariance(server.context.store, scan)
    part = keep(server, "plate.stl", stl_bytes(PLATE.corners()))
    found = compare(server, part["id"])
    shown = found["shown"]
    assert shown["legend"]["mode"] == "deviation"
    result = shown["result"]
    assert result["uncertainty"] == "scatter"
    assert result["counts"]["inside"] == result["counts"]["outside"] == 0
    assert any("has no covariance" in english(one) for one in result["warnings"])
    asked = {"on": True, "mode": "uncertainty"}
    answer = server.http.post("/api/scans/plate/deviation/shown", json=asked)
    assert code_of(answer) == (422, "scatter-only")


def test_parts_and_maps_outlast_a_restart(tmp_path: Path) -> None:
    with running_server(tmp_path) as server:
        add_plate_scan(server.context.store, "plate")
        part = keep(server, "plate.stl", stl_bytes(PLATE.corners()))
        compare(server, part["id"])
        before = server.http.get("/api/scans/plate/deviation").json()
    with running_server(tmp_path) as server:
        found = state(server)
        assert [one["name"] for one in found["parts"]] == ["plate.stl"]
        assert found["parts"][0]["unit"] == "mm"
        assert found["shown"] is None
        assert server.http.get("/api/scans/plate/deviation").json() == before
        body = {"on": True, "mode": "significance"}
        answer = server.http.post("/api/scans/plate/deviation/shown", json=body)
        assert answer.json()["shown"]["result"]["counts"] == before["counts"]
