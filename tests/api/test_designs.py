"""Designs of blocks and boards by HTTP: those of ``crenel design``."""

import json
from pathlib import Path
from typing import Any
from unittest.mock import patch

import httpx
import pytest

from crenel.api.access.browser import cookie_for
from crenel.formats.drawings import dxf
from crenel.store.accounts import Role
from tests.api.conftest import PATIENCE_S, Server, code_of, wait_for
from tests.cli.test_cli import printed, refused
from tests.sent_texts import english

pytestmark = pytest.mark.device

NUMBERS = {
    "field_of_view_mm": 55.0,
    "depth_of_field_mm": 20.0,
    "standoff_mm": 115.0,
    "angle_deg": 30.0,
    "width_px": 1280,
    "height_px": 1024,
    "stripe_axis": "u",
}
BOARD = {"kind": "charuco", "columns": 11, "rows": 8, "square_mm": 20.0, "name": "Board 4"}


def ask(server: Server, **changes: object) -> httpx.Response:
    return server.http.post("/api/designs/block", json={"page": "a page", **NUMBERS, **changes})


@pytest.fixture(scope="module")
def design(server: Server) -> dict[str, Any]:
    """What the page shows once the block is there."""
    states = wait_for(
        lambda: ask(server).raise_for_status().json(), lambda state: state["design"] is not None
    )
    return dict(states["design"])


def test_a_block_is_that_of_the_command_and_its_datasheet_can_be_kept(
    server: Server, design: dict[str, Any], tmp_path: Path
) -> None:
    numbers = ("--field-of-view", 55, "--depth-of-field", 20, "--standoff", 115)
    made = printed("design", "block", *numbers, "--pixels", "1280x1024", "-o", tmp_path)
    document = json.loads(design["document"])
    assert document | {"name": ""} == made["object"] | {"name": ""}
    best = design["accuracies"][0]
    assert best["one_pose"]["value"] == pytest.approx(made["one_pose_um"])
    assert best["eight_poses"]["value"] == pytest.approx(made["eight_poses_um"])
    assert design["dxf_why_not"] == ""
    for file, begin in (
        ("block.pdf", b"%PDF"),
        ("block.dxf", b"  0"),
        ("block.stl", b"Crenel"),
        ("block.step", b"ISO-10303"),
    ):
        answer = server.http.get(
            f"/api/designs/block/{design['id']}/{file}", params={"name": "Block 9", "lang": "de"}
        ).raise_for_status()
        assert answer.content.startswith(begin)
        assert file in answer.headers["content-disposition"]
    kept = json.dumps(document | {"name": "Block 9", "serial_number": "D-1"})
    checked = server.http.post("/api/datasheets/check", json={"text": kept}).json()
    assert (checked["form"], checked["problems"]) == ("block", [])


def test_without_the_extra_the_page_says_how_to_get_it(
    server: Server, design: dict[str, Any]
) -> None:
    with patch.object(dxf, "LIBRARY", "no_such_library"):
        why = ask(server).json()["design"]["dxf_why_not"]
        assert "crenel[cad]" in english(why)
        path = f"/api/designs/block/{design['id']}/block.dxf"
        answer = server.http.get(path, params={"name": "Block"})
    assert code_of(answer)[1] == "extra-missing"
    gone = server.http.get("/api/designs/block/0123/block.pdf", params={"name": "Block"})
    assert code_of(gone)[1] == "no-design"


def test_numbers_of_no_sensor_are_refused_in_the_words_of_the_command(
    server: Server, tmp_path: Path
) -> None:
    flat = {"depth_of_field_mm": 1.0}
    answer = wait_for(lambda: ask(server, **flat), lambda answer: answer.status_code != 200)
    assert code_of(answer) == (422, "sensor-numbers")
    numbers = ("--field-of-view", 55, "--depth-of-field", 1, "--standoff", 115)
    said = refused("design", "block", *numbers, "--pixels", "1280x1024", "-o", tmp_path)
    assert answer.json()["detail"].rstrip(".") in said
    wide = wait_for(lambda: ask(server, width_mm=60.0), lambda answer: answer.status_code != 200)
    assert code_of(wide) == (422, "block-sizes")
    assert code_of(ask(server, arm="none.json"))[1] == "no-datasheet"
    assert ask(server, standoff_mm=0.0).status_code == 422


def test_a_board_is_that_of_the_command_and_scaled_by_its_print(
    server: Server, tmp_path: Path
) -> None:
    def board(path: str = "", **changes: object) -> httpx.Response:
        return server.http.get(f"/api/designs/board{path}", params=BOARD | changes)  # type: ignore[arg-type]

    plain = board().raise_for_status().json()
    command = ("design", "board", "charuco", "--squares", "11x8", "--square", 20)
    made = printed(*command, "--name", "Board 4", "-o", tmp_path)
    assert json.loads(plain["document"]) == made["object"]
    assert (plain["width_mm"], plain["height_mm"], plain["page"]) == (220.0, 160.0, "A3")
    assert board("/board.pdf").content == (tmp_path / "board.pdf").read_bytes()
    measured: dict[str, Any] = {"measured_x_mm": 219.78, "measured_y_mm": 159.84}
    scaled = board(**measured).raise_for_status().json()
    assert json.loads(scaled["document"])["square_mm"] == 19.98
    assert (scaled["width_mm"], scaled["page"]) == (220.0, "A3")
    assert board(page="tabloid").raise_for_status().json()["page"] == "tabloid"
    made = printed(*command, "--name", "Board 4", "--page", "Tabloid", "-o", tmp_path)
    tabloid = board("/board.pdf", page="tabloid").raise_for_status()
    assert tabloid.content == (tmp_path / "board.pdf").read_bytes()
    bad: tuple[tuple[dict[str, Any], str], ...] = (
        ({"columns": 3}, "board-squares"),
        ({"square_mm": 300.0}, "board-too-large"),
        ({"measured_x_mm": 100.0, "measured_y_mm": 80.0}, "board-scale"),
        ({"measured_x_mm": 219.78}, "board-measured"),
        ({"measured_y_mm": 159.84}, "board-measured"),
        ({"page": "A4"}, "board-too-large"),
        ({"first_id": 957}, "board-ids"),
    )
    for changes, code in bad:
        assert code_of(board(**changes)) == (422, code)


def test_viewers_do_not_design(server: Server) -> None:
    accounts = server.context.store.accounts
    accounts.add("design viewer", Role.viewer, None)
    session = server.context.store.login_sessions.begin("design viewer", "test")
    try:
        headers = {"Cookie": f"{cookie_for(server.port)}={session}"}
        with httpx.Client(base_url=server.address, timeout=PATIENCE_S, headers=headers) as http:
            asked = http.post("/api/designs/block", json={"page": "a page", **NUMBERS})
            assert code_of(asked) == (403, "role")
            assert code_of(http.get("/api/designs/board", params=BOARD)) == (403, "role")  # type: ignore[arg-type]
    finally:
        accounts.remove("design viewer")
