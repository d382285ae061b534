"""Any bad file among the datasheets is set aside by its name, also at a start; all else works."""

import json
import os
from collections.abc import Callable, Mapping
from functools import partial
from pathlib import Path
from typing import Any

import httpx
import pytest

from crenel.formats.open_file import LARGEST_DOCUMENT
from tests.api.calibrated import use_truth
from tests.api.conftest import running_server, wait_for
from tests.gauges.exchange.certificates import DIAMETER, certificate, expanded, quantity, real
from tests.sent_texts import english

pytestmark = pytest.mark.device

FOLDERS = ("arms", "objects", "sensors", "gauges")
GUIDES = ("flow", "arm", "verify", "performance")
PAGES = (*GUIDES, "health", "home", "devices", "calibrations", "scan", "scans", "performances")
Document = dict[str, Any]
TINY = "5e-324"


def nested(depth: int, opening: str, closing: str, inner: str = "") -> str:
    return opening * depth + inner + closing * depth


def with_numbers(value: Any, number: float) -> Any:
    """A document with each of its numbers replaced, but that of its version."""
    if isinstance(value, dict):
        return {k: v if k == "version" else with_numbers(v, number) for k, v in value.items()}
    if isinstance(value, list):
        return [with_numbers(one, number) for one in value]
    return number if isinstance(value, int | float) else value


CONTENTS: Mapping[str, bytes] = {
    "empty": b"",
    "blank": b" \n",
    "no-json": b"<a/",
    "zeros": bytes(1000),
    "utf-16": "{}".encode("utf-16"),
    "latin-1": '{"name": "Prüfkörper"}'.encode("latin-1"),
    "half-character": b'{"name": "\\ud800"}',
    "list": b"[]",
    "list-in-lists": nested(100_000, "[", "]").encode(),
    "object-in-objects": nested(100_000, '{"a":', "}", "1").encode(),
    "digits": b'{"a": ' + b"9" * 5000 + b"}",
}
"""The same in every folder."""

DOCUMENTS: Mapping[str, Callable[[Document], str]] = {
    "cut": lambda document: json.dumps(document)[:-5],
    "other-format": lambda document: json.dumps({**document, "format": "crenel/other"}),
    "format-missing": lambda document: json.dumps({**document, "format": None}),
    "newer": lambda document: json.dumps({**document, "version": 2}),
    "version-true": lambda document: json.dumps({**document, "version": True}),
    "bare": lambda document: json.dumps({k: document[k] for k in ("format", "version")}),
    "texts": lambda document: json.dumps(dict.fromkeys(document, "x") | {"version": 1}),
    "tiny": lambda document: json.dumps(with_numbers(document, 5e-324)),
    "huge": lambda document: json.dumps(with_numbers(document, 1e308)),
    "infinite": lambda document: json.dumps(with_numbers(document, 1.0)).replace("1.0", "1e999"),
    "negative": lambda document: json.dumps(with_numbers(document, -1.0)),
    "nan": lambda document: json.dumps(with_numbers(document, float("nan"))),
    "deep": lambda document: json.dumps({**document, "note": json.loads(nested(400, "[", "]"))}),
    "names-in-names": lambda document: json.dumps({**document, "name": [document] * 3}),
}
"""A good document of each folder, spoilt."""


def make_too_large(path: Path) -> None:
    with path.open("wb") as file:
        file.truncate(LARGEST_DOCUMENT + 1)


FILES: Mapping[str, Callable[[Path], object]] = {
    "folder": Path.mkdir,
    "pipe": os.mkfifo,
    "link-to-itself": lambda path: path.symlink_to(path),
    "link-to-nothing": lambda path: path.symlink_to("nothing"),
    "device": lambda path: path.symlink_to("/dev/zero"),
    "too-large": make_too_large,
}
"""What is no file."""


def sized(value: str, uncertainty: str = "0.001", name: str = "Diameter") -> str:
    """The certificate of one size, in mm."""
    return certificate(quantity(name, real(value, "\\milli\\metre", expanded(uncertainty))))


def within(tag: str, depth: int) -> str:
    return certificate(nested(depth, f"<dcc:{tag}>", f"</dcc:{tag}>", DIAMETER))


CERTIFICATES: Mapping[str, str] = {
    "lists": within("list", 900),
    "more-lists": within("list", 8_000),
    "data": within("data", 8_000),
    "many-elements": nested(300_000, "<a>", "</a>"),
    "tiny": sized(TINY),
    "tiny-radius": sized(TINY, TINY, "Radius"),
    "small": sized("0.0015"),
    "large-radius": sized("400", name="Radius"),
    "huge": sized("1e308"),
    "infinite": sized("1e999"),
    "negative": sized("-25"),
    "no-number": sized("25,0"),
    "uncertain": sized("25", "1e300"),
    "tiny-factor": certificate(quantity("Diameter", real("25", "\\metre", expanded("1", TINY)))),
    "without-uncertainty": certificate(quantity("Diameter", real("25", "\\milli\\metre"))),
    "without-size": certificate(),
    "two-sizes": certificate(DIAMETER, DIAMETER),
    "entities": f'<!DOCTYPE a [<!ENTITY b "{"c" * 99}">]><a>&b;</a>',
    "newer": certificate(DIAMETER, version="4.0.0"),
    "cut": certificate(DIAMETER)[:-20],
}

BAD: Mapping[str, Callable[[Path, Document], object]] = {
    **{name: partial(lambda c, path, _: path.write_bytes(c), c) for name, c in CONTENTS.items()},
    **{
        f"document-{name}": partial(lambda d, path, good: path.write_text(d(good)), spoilt)
        for name, spoilt in DOCUMENTS.items()
    },
    **{f"a-{name}": partial(lambda m, path, _: m(path), make) for name, make in FILES.items()},
}


@pytest.fixture(scope="module")
def data(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The data folder of a station with a calibration in use."""
    data = tmp_path_factory.mktemp("station")
    with running_server(data) as server:
        use_truth(server, "truth")
    return data


def test_home_leads_from_camera_and_mounting_alone_to_the_laser(tmp_path: Path) -> None:
    with running_server(tmp_path) as server:
        use_truth(server, "camera")
        file = tmp_path / "sessions" / "camera" / "calibration.json"
        document = json.loads(file.read_text())
        del document["laser_plane"]
        file.write_text(json.dumps(document))
        server.context.guide._on_closed()
        home = server.http.get("/api/home").json()
    assert home["lacks_laser"] is True
    assert (english(home["next"]["label"]), home["next"]["page"]) == ("Add the laser", "calibrate")
    assert "no laser plane" in english(home["next"]["text"])


def named_in_health(http: httpx.Client) -> str:
    health = wait_for(lambda: http.get("/api/health").json()["health"], bool)
    failed = [one["id"] for one in health["items"] if one["id"].startswith("not-made")]
    assert not failed
    return next(english(one["what"]) for one in health["items"] if one["id"] == "datasheets")


def everything_works(http: httpx.Client) -> None:
    """All pages, and a session of every kind with the good datasheets."""
    for page in PAGES:
        answer = http.get(f"/api/{page}")
        assert answer.status_code == 200, (page, answer.text)
    starts = {"flow": None, "arm": {"purpose": "check"}, "verify": None, "performance": None}
    for guide, body in starts.items():
        if (activity := http.get("/api/activity").json()["activity"]) is not None:
            http.post("/api/activity/end", json={"id": activity["id"]}).raise_for_status()
        answer = http.post(f"/api/{guide}/start", json=body)
        assert answer.status_code == 200, (guide, answer.text)
        assert answer.json()["running"]
    for guide in ("verify", "performance"):
        view = http.get(f"/api/{guide}").json()
        assert "sphere" in {one["id"] for one in view["gauges"] if not one.get("why_not")}
    assert wait_for(lambda: http.get("/api/home").json(), bool)["calibration"]["active"]


EACH = [pytest.param([kind], id=kind, marks=pytest.mark.soak) for kind in BAD]


@pytest.mark.parametrize("kinds", [pytest.param(list(BAD), id="all"), *EACH])
def test_bad_datasheets_in_each_folder_are_set_aside(data: Path, kinds: list[str]) -> None:
    paths = []
    for folder in FOLDERS:
        good = json.loads(next((data / folder).glob("*.json")).read_text())
        for kind in kinds:
            paths.append(data / folder / f"zz-{kind}.json")
            BAD[kind](paths[-1], good)
    try:
        with running_server(data) as server:
            everything_works(server.http)
            named = named_in_health(server.http)
    finally:
        for path in paths:
            path.rmdir() if path.is_dir() else path.unlink()
    assert [str(one) for one in paths if f"{one.parent.name}/{one.name}" not in named] == []


def test_bad_certificates_are_not_kept_and_those_in_the_folder_are_set_aside(data: Path) -> None:
    gauges = data / "gauges"
    before = sorted(gauges.iterdir())
    with running_server(data) as server:
        http = server.http
        for name, text in CERTIFICATES.items():
            body = {"name": f"{name}.xml", "text": text}
            answer = http.post("/api/performance/certificate", json=body)
            status = 413 if len(text) > 250_000 else 422
            assert answer.status_code == status, (name, answer.text)
        assert named_in_health(http) == "All datasheets and certificates are readable."
        everything_works(http)
    assert sorted(gauges.iterdir()) == before
    for name, text in CERTIFICATES.items():
        (gauges / f"bad-{name}.xml").write_text(text)
    with running_server(data) as server:
        http = server.http
        everything_works(http)
        named = named_in_health(http)
        assert [one for one in CERTIFICATES if f"gauges/bad-{one}.xml" not in named] == []
    for name in CERTIFICATES:
        (gauges / f"bad-{name}.xml").unlink()
