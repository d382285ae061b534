"""A refused picture is shown with what was found in it, and saved with its context."""

import io
import json
import zipfile

import httpx
import pytest

from tests.api.conftest import Server, is_enabled
from tests.pictures import decode_picture

pytestmark = pytest.mark.device


@pytest.fixture
def refused(at_setup: Server) -> Server:
    """At the step after a picture that does not show the chessboard."""
    server = at_setup
    server.do("choose", field="object", id="chessboard")
    for step in ("confirm_setup", "confirm_touch", "confirm_place"):
        server.do(step)
    server.wait(lambda view: is_enabled(view, "capture"))
    server.do("capture")
    server.wait(lambda view: view["step"] == "solve" and view["busy"] is None)
    return server


def bundle_of(answer: httpx.Response) -> zipfile.ZipFile:
    assert (answer.status_code, answer.headers["content-type"]) == (200, "application/zip")
    assert answer.headers["content-disposition"].startswith('attachment; filename="crenel-picture-')
    return zipfile.ZipFile(io.BytesIO(answer.content))


def test_a_refused_picture_is_saved_with_its_context(refused: Server) -> None:
    view = refused.flow()
    (pose,) = view["picture"]["poses"]
    assert pose["note"]
    assert pose["bundle_url"].startswith(f"/api/flow/picture/{pose['number']}.zip")
    bundle = bundle_of(refused.http.get(pose["bundle_url"]))
    assert bundle.testzip() is None
    pictures = {name for name in bundle.namelist() if name.endswith(".png")}
    number = pose["number"]
    assert pictures == {"found.png", f"capture-{number}-ambient.png", f"capture-{number}-laser.png"}
    for name in pictures:
        image = decode_picture(bundle.read(name))
        assert image.shape[:2] == (pose["height_px"], pose["width_px"])
    assert json.loads(bundle.read("object.json"))["kind"] == "chessboard"
    assert json.loads(bundle.read("sensor.json"))["format"] == "crenel/sensor"
    context = json.loads(bundle.read("context.json"))
    assert context["software"]["Crenel"]
    assert context["exposure_us"] > 0
    assert len(context["reading"]) == 6
    bad = next(one for one in context["findings"] if one["quality"] == "bad")
    assert bad["text_message"] in [one["text"] for one in view["findings"]]
    assert bad["text_message"]["message_id"] == "fault"
    assert context["fault"] in ("framing", "object", "focus", "exposure", "lighting")


def test_the_bundle_names_neither_folders_nor_people_nor_secrets(refused: Server) -> None:
    (pose,) = refused.flow()["picture"]["poses"]
    bundle = bundle_of(refused.http.get(pose["bundle_url"]))
    texts = b"".join(bundle.read(name) for name in bundle.namelist() if not name.endswith(".png"))
    assert str(refused.data).encode() not in texts
    for account in refused.context.store.accounts.all():
        assert account.name.encode() not in texts


def test_what_is_not_there_is_not_found(refused: Server) -> None:
    assert refused.http.get("/api/flow/picture/77.zip").status_code == 404
    assert refused.http.get("/api/flow/picture/0.zip").status_code in (404, 422)
    assert httpx.get(f"{refused.address}/api/flow/picture/1.zip").status_code == 401
