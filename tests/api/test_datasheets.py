"""Datasheets by HTTP: evaluated before they are kept, and never lost."""

import json
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from errno import ENOSPC
from pathlib import Path
from typing import Any

import httpx
import pytest

from crenel.api.access.browser import cookie_for
from crenel.formats.atomic_write import write_atomically
from crenel.formats.datasheets.target import ObjectFile
from crenel.gauges.quick.document import GAUGE
from crenel.messages.catalogue import in_english
from crenel.operations.datasheets import files as datasheet_files
from crenel.operations.datasheets.documents import DatasheetIdentity
from crenel.operations.datasheets.last_uses import CalibrationInUse, Uses, content_version
from crenel.store.accounts import Role
from tests.api.conftest import PATIENCE_S, Server, code_of
from tests.cli.test_cli import printed
from tests.gauges.exchange.certificates import DIAMETER, FORM, certificate, quantity, real
from tests.sent_texts import english

pytestmark = pytest.mark.device

FOLDERS = ("arms", "objects", "sensors", "gauges")
SPHERE = certificate(DIAMETER, FORM)
BARE = certificate(quantity("Diameter", real("25", "\\milli\\metre")))
BLOCK = {
    "format": "crenel/object",
    "version": 1,
    "name": "Block",
    "serial_number": "B-7",
    "edges_x_mm": [-24, -15, -7, -1, 6, 12, 19, 24],
    "front_y_mm": -13,
    "back_y_mm": 13,
    "crest_z_mm": 15,
    "floor_z_mm": 0,
    "base_z_mm": -12,
    "standard_uncertainty_mm": 0.002,
}
JOINT = {"a_mm": 100, "alpha_deg": 90, "d_mm": 50, "theta_deg": 0, "limits_deg": [-170, 170]}
ARM = {
    "format": "crenel/arm",
    "version": 1,
    "name": "Own arm",
    "serial_number": "A-1",
    "convention": "dh-standard",
    "joints": [{"name": f"J{number}", **JOINT} for number in range(1, 7)],
    "tip": {"x_mm": 0, "y_mm": 0, "z_mm": 120, "diameter_mm": 6},
}

STEPS = {"format": "crenel/length-standard", "version": 1, "name": "Steps", "kind": "step-gauge"}


Document = dict[str, Any]
Refused = tuple[str, str, str, str]
"""The text of a datasheet, and the code, the field and some words of its refusal."""


def text_of(document: Document, **changes: object) -> str:
    return json.dumps({**document, **changes})


def changed_joint(**changes: object) -> list[dict[str, Any]]:
    third = {name: value for name, value in {**JOINT, **changes}.items() if value is not None}
    joints = list(ARM["joints"])  # type: ignore[call-overload]
    return [*joints[:2], {"name": "J3", **third}, *joints[3:]]


@pytest.fixture
def station(server: Server) -> Iterator[Server]:
    """Its own datasheets of the simulation stay; what a test adds is removed."""
    before = set(files(server))
    yield server
    for name in set(files(server)) - before:
        (server.data / name).unlink()


def files(server: Server) -> dict[str, bytes]:
    """Every file below the folders of datasheets, also hidden ones."""
    paths = [path for folder in FOLDERS for path in (server.data / folder).rglob("*")]
    return {
        path.relative_to(server.data).as_posix(): path.read_bytes()
        for path in paths
        if path.is_file()
    }


def post(server: Server, path: str = "", **body: object) -> httpx.Response:
    return server.http.post(f"/api/datasheets{path}", json=body)


def add(server: Server, text: str, name: str = "", **more: object) -> dict[str, Any]:
    body = {"name": name, "text": text} | more
    return dict(server.http.post("/api/datasheets", json=body).raise_for_status().json())


def rows(server: Server, **wanted: object) -> list[dict[str, Any]]:
    found = server.http.get("/api/datasheets").raise_for_status().json()["rows"]
    return [row for row in found if wanted.items() <= row.items()]


def reference(row: dict[str, Any]) -> dict[str, Any]:
    return {name: row[name] for name in ("kind", "file", "version")}


JOINT_TABLE = "a,alpha,d,theta\n" + "1,0,1,0\n" * 6
URDF = '<?xml version="1.0"?>\n<!-- made by xacro -->\n<robot name="r"/>'
SENSOR = {"format": "crenel/sensor", "version": 1, "name": "S", "stripe_axis": "u"}
NOMINAL = {"format": "crenel/nominal", "version": 1, "shape": "sphere"}
RESULT = {"format": "crenel/calibration", "version": 1}
NEGATIVE = {"length_mm": 20, "standard_uncertainty_um": -1}
MICROMETRES = {"width_px": 640, "height_px": 480, "laser_wavelength_nm": 0.66}


def invalid(field: str, words: str, document: Document, **changes: object) -> Refused:
    """A datasheet with changes by which a field has a value that it cannot have."""
    return text_of(document, **changes), "field-invalid", field, words


def bad_joint(term: str, words: str, value: object) -> Refused:
    """The arm with another value of its third joint."""
    return invalid(f"joints.2.{term}", words, ARM, joints=changed_joint(**{term: value}))


BAD: dict[str, Refused] = {
    "a joint without its length": (
        text_of(ARM, joints=changed_joint(a_mm=None)),
        "field-missing",
        "joints.2.a_mm",
        "arm.json",
    ),
    "limits swapped": bad_joint("limits_deg", "J3", [170, -170]),
    "a row missing": invalid("joints", "4", ARM, joints=changed_joint()[:4]),
    "text instead of a number": bad_joint("d_mm", "1,2,3", "1,2,3"),
    "crest and floor swapped": invalid("crest_z_mm", "crest", BLOCK, crest_z_mm=0, floor_z_mm=15),
    "its own mirror image": invalid(
        "edges_x_mm", "mirror image", BLOCK, edges_x_mm=[-20, -10, 10, 20]
    ),
    "an uncertainty in µm": invalid(
        "standard_uncertainty_mm", "standard_uncertainty_mm", BLOCK, standard_uncertainty_mm=2
    ),
    "a length in a list of one": invalid(
        "lengths.0.standard_uncertainty_um", "-1", STEPS, lengths=[NEGATIVE]
    ),
    "a picture without width": (text_of(SENSOR), "field-missing", "width_px", "width_px"),
    "a sphere without its size": invalid("radius_mm", "radius_mm", NOMINAL),
    "no certificate": ("<a/>", "no-certificate", "", "arm.json"),
    "a certificate without uncertainty": (BARE, "certificate-without-uncertainty", "", "Diameter"),
    "a result": (text_of(RESULT), "file-of-another-format", "", "crenel/object"),
    "half a file": (text_of(BLOCK).split("-24")[0], "file-not-json", "", "line"),
    "no format": ('{"name": "x"}', "file-of-another-format", "", "states no format"),
    "a letter": ("Dear all,", "file-not-json", "", "no datasheet as JSON"),
    "a table of joints": (JOINT_TABLE, "file-not-json", "", "no datasheet as JSON"),
    "a robot": (URDF, "file-not-json", "", "no datasheet as JSON"),
    "a long name": invalid("name", "at most 120", BLOCK, name="b" * 121),
    "a wavelength in µm": invalid("laser_wavelength_nm", "at least 200", SENSOR, **MICROMETRES),
    "nothing": ("", "file-not-json", "", "empty"),
    "nested": ("[" * 5000, "file-not-json", "", "nested"),
}


@pytest.mark.parametrize(("text", "code", "field", "words"), BAD.values(), ids=BAD)
def test_what_cannot_be_used_is_not_kept(
    station: Server, text: str, code: str, field: str, words: str
) -> None:
    before = files(station)
    refused = post(station, name="arm.json", text=text)
    assert (refused.status_code, refused.json()["code"]) == (422, code)
    assert words in refused.json()["detail"]
    checked = post(station, "/check", name="arm.json", text=text).raise_for_status().json()
    assert checked["form"] is None
    assert field in [problem["field"] for problem in checked["problems"]]
    assert all(problem["text"] for problem in checked["problems"])
    assert "lengths" not in [problem["field"] for problem in checked["problems"]]
    assert files(station) == before


def test_who_gives_the_model_of_an_arm_as_a_datasheet_is_sent_to_its_form(station: Server) -> None:
    remedies = [
        post(station, name="arm", text=text).json()["remedy"]
        for text in (JOINT_TABLE, URDF, "Dear all,")
    ]
    assert ["Arm with joints" in one for one in remedies] == [True, True, False]


def test_fifty_megabytes_are_refused(station: Server) -> None:
    before = files(station)
    text = text_of(BLOCK, name="b" * (50 << 20))
    assert code_of(post(station, text=text)) == (413, "bad-request")
    assert files(station) == before


@pytest.mark.parametrize(
    ("name", "file"),
    [
        ("Block 7 (2026).json", "Block-7-2026.json"),
        ("../../arms/x.json", "x.json"),
        ("/etc/passwd", "passwd.json"),
        ("..", "datasheet.json"),
        ("a\0b\n.json", "a-b.json"),
        ("b" * 190 + ".json", "b" * 60 + ".json"),
        ("", "Block-B-7.json"),
    ],
)
def test_a_file_gets_a_safe_name_and_can_be_downloaded(
    station: Server, name: str, file: str
) -> None:
    before, text = files(station), text_of(BLOCK)
    added = add(station, text, name)
    assert (added["kind"], added["form"], added["file"]) == ("object", "block", file)
    assert files(station) == before | {f"objects/{file}": text.encode()}
    answer = station.http.get(f"/api/datasheets/object/{file}").raise_for_status()
    assert answer.text == text
    assert file in answer.headers["content-disposition"]
    assert station.http.get("/api/datasheets/object/..%2Fstation.toml").status_code == 404


def test_a_thing_has_one_datasheet_and_its_former_ones_are_kept(station: Server) -> None:
    first, second = text_of(BLOCK), text_of(BLOCK, crest_z_mm=16, serial_number=" b-7")
    add(station, first, "block.json")
    assert add(station, first, "again.json")["file"] == "block.json", "it is there already"
    before = files(station)
    assert code_of(post(station, name="new.json", text=second)) == (409, "datasheet-exists")
    other = text_of(BLOCK, serial_number="")
    assert code_of(post(station, name="new.json", text=other)) == (409, "datasheet-exists")
    assert files(station) == before
    assert add(station, second, "new.json", replace=True)["file"] == "block.json"
    left = {"objects/block.json": second.encode(), "objects/retired/block.json": first.encode()}
    assert files(station) == before | left
    # another unit of this kind of block is no other version
    assert add(station, text_of(BLOCK, serial_number="B-8"), "block.json")["file"] == "block-2.json"
    # two files of one thing, put there by hand, are asked about together
    (station.data / "objects/twice.json").write_text(first)
    (listed,) = rows(station, file="block.json", kind="object", retired=False)
    assert "twice.json describes the same thing" in english(listed["note"])
    assert code_of(post(station, text=text_of(BLOCK, crest_z_mm=17))) == (409, "datasheet-exists")
    add(station, text_of(BLOCK, crest_z_mm=17), replace=True)
    assert len(rows(station, kind="object", serial_number="B-7", retired=False)) == 1
    contents = [one for name, one in files(station).items() if "retired" in name]
    assert sorted(contents) == sorted([first.encode(), first.encode(), second.encode()])


def test_a_certificate_and_a_datasheet_of_one_gauge_take_each_others_place(station: Server) -> None:
    added = add(station, SPHERE, "Kugel 25 (K-17).xml")
    assert (added["file"], added["form"]) == ("Kugel-25-K-17.xml", "sphere")
    assert (added["certificate"], added["valid_until"]) == ("4711-2026", "2028-03-12")
    own = {"format": "crenel/nominal", "version": 1, "shape": "sphere", "radius_mm": 12.5}
    text = text_of(own, name="Sphere", serial_number="K-17")
    add(station, text, replace=True)
    kept = [name for name in files(station) if "Kugel" in name or "Sphere-K" in name]
    assert sorted(kept) == ["gauges/Sphere-K-17.json", "gauges/retired/Kugel-25-K-17.xml"]


def test_two_people_lose_nothing(station: Server) -> None:
    version = add(station, text_of(BLOCK))["version"]
    mine, yours = text_of(BLOCK, crest_z_mm=16), text_of(BLOCK, crest_z_mm=17)
    add(station, mine, edited=version)
    assert code_of(post(station, text=yours, edited=version)) == (409, "datasheet-changed")
    (row,) = rows(station, serial_number="B-7", retired=False)
    assert code_of(post(station, "/retire", **reference(row) | {"version": version})) == (
        409,
        "datasheet-changed",
    )
    # an edited copy may be another thing, but takes no third one's place unasked
    add(station, text_of(BLOCK, serial_number="B-8"))
    taken = post(station, text=text_of(BLOCK, serial_number="B-8", crest_z_mm=16.5), edited=version)
    assert taken.status_code == 409
    texts = [
        text_of(BLOCK, serial_number=f"C-{number % 4}", base_z_mm=-20 - number)
        for number in range(8)
    ]
    with ThreadPoolExecutor(8) as people:
        answers = list(people.map(lambda text: post(station, text=text, replace=True), texts))
    assert {answer.status_code for answer in answers} == {200}
    assert {text.encode() for text in texts} <= set(files(station).values())
    assert (
        len([row for row in rows(station, retired=False) if row["serial_number"][:1] == "C"]) == 4
    )


def test_a_retired_datasheet_is_kept_and_comes_back(station: Server) -> None:
    row = add(station, text_of(BLOCK), "block.json")
    post(station, "/retire", **reference(row)).raise_for_status()
    assert code_of(post(station, "/retire", **reference(row))) == (404, "no-datasheet")
    (retired,) = rows(station, file="block.json", kind="object")
    assert retired == {**row, "retired": True}, "with its time"
    where = "/api/datasheets/object/block.json"
    assert station.http.get(where).status_code == 404
    assert station.http.get(f"{where}?retired=true").text == text_of(BLOCK)
    add(station, text_of(BLOCK, crest_z_mm=16), "newer.json")
    assert code_of(post(station, "/restore", **reference(retired))) == (409, "datasheet-exists")
    post(station, "/restore", **reference(retired), replace=True).raise_for_status()
    assert [one["file"] for one in rows(station, serial_number="B-7", retired=False)] == [
        "block.json"
    ]
    assert rows(station, file="newer.json", retired=True)


def test_a_file_that_cannot_be_read_is_listed_with_its_reason_and_can_be_retired(
    station: Server,
) -> None:
    (station.data / "objects/damaged.json").write_text(text_of(BLOCK, edges_x_mm=[1, 2, 3]))
    (station.data / "arms/block.json").write_text(text_of(BLOCK))
    (damaged,) = rows(station, file="damaged.json")
    assert "edges_x_mm" in english(damaged["problem"])
    (wrong,) = rows(station, file="block.json", kind="arm")
    assert "crenel/arm" in english(wrong["problem"])
    post(station, "/retire", **reference(damaged)).raise_for_status()
    (retired,) = rows(station, file="damaged.json")
    assert retired["retired"]
    assert post(station, "/restore", **reference(retired)).json()["code"] == "datasheet-unreadable"


def test_on_a_full_disk_the_version_before_stays(
    station: Server, monkeypatch: pytest.MonkeyPatch
) -> None:
    add(station, text_of(BLOCK), "block.json")
    before = files(station)

    def fill(path: Path, content: bytes) -> None:
        if path.parent.name != "retired":
            raise OSError(ENOSPC, "no space")
        write_atomically(path, content)

    monkeypatch.setattr(datasheet_files, "write_atomically", fill)
    refused = post(station, text=text_of(BLOCK, crest_z_mm=16), replace=True)
    assert code_of(refused) == (507, "disk-full")
    assert files(station) == before


def test_an_arm_with_other_joints_than_the_connected_one_is_noticed(station: Server) -> None:
    arm = station.context.rig.arm.info
    assert arm is not None
    five = text_of(ARM, joints=changed_joint()[:5], serial_number=arm.serial_number)
    checked = post(station, "/check", text=five).json()
    assert checked["form"] == "arm"
    assert f"has {arm.joint_count} joints, this model has 5" in english(checked["note"])
    for fits in (
        text_of(ARM, joints=changed_joint()[:5]),
        text_of(ARM, serial_number=arm.serial_number),
    ):
        assert not post(station, "/check", text=fits).json()["note"]


def test_the_page_has_the_ranges_and_how_the_arm_stands(station: Server) -> None:
    view = station.http.get("/api/datasheets").raise_for_status().json()
    arm, ranges = station.context.rig.arm.info, view["ranges"]
    assert arm is not None
    joints_deg = station.http.get("/api/datasheets/joints").raise_for_status().json()["joints_deg"]
    assert len(joints_deg) == arm.joint_count == view["arm"]["joint_count"]
    for form, field, least, most in (
        ("chessboard", "inner_corners.0", 3, 200),
        ("block", "standard_uncertainty_mm", 0, 0.1),
        ("charuco", "square_mm", 0.2, None),
        ("step-gauge", "lengths.*.length_mm", 0.001, None),
    ):
        assert (ranges[form][field]["least"], ranges[form][field]["most"]) == (least, most)


def test_a_datasheet_that_is_used_says_when(station: Server, calibration: str) -> None:
    (used,) = rows(station, kind="sensor", connected=True)
    record = station.context.store.calibrations.get(calibration)
    assert record is not None
    assert used["last_use"]["at"] == record.accepted_at
    assert used["last_use"]["quality"] == record.figures.verdict
    assert used["in_use"] == [record.name]
    assert add(station, text_of(BLOCK))["last_use"] is None


@pytest.mark.parametrize(
    ("kind", "serial", "change"),
    [
        ("object", "object_serial", {"certificate": "DKD 4711, 2026-12"}),
        ("sensor", "sensor_serial", {"name": "Another name"}),
    ],
)
def test_a_datasheet_that_is_newer_than_the_calibration_says_so(
    station: Server, calibration: str, kind: str, serial: str, change: dict[str, object]
) -> None:
    """The result keeps its own."""
    record = station.context.store.calibrations.get(calibration)
    assert record is not None
    (row,) = rows(station, kind=kind, serial_number=getattr(record.figures, serial), retired=False)
    text = files(station)[f"{kind}s/{row['file']}"].decode()
    copy = record.file.parent / f"{kind}.json"
    before = copy.read_text() if copy.is_file() else None
    copy.write_text(text)
    assert not rows(station, kind=kind, file=row["file"], retired=False)[0]["note"]
    newer = text_of(json.loads(text), **change)
    assert record.name in english(add(station, newer, edited=row["version"])["note"])
    assert copy.read_text() == text
    add(station, text, replace=True)
    if before is None:
        copy.unlink()
    else:
        copy.write_text(before)


def test_an_arm_or_a_gauge_that_is_newer_than_what_rests_on_it_says_so(tmp_path: Path) -> None:
    same, other = (content_version(text.encode(), "arm") for text in ("{}", "{ }"))
    arm, plate = (
        DatasheetIdentity("arm", "arm", "Own arm", "A-1"),
        DatasheetIdentity("gauge", "plane", "Plate P-1", "P-1"),
    )
    in_use = CalibrationInUse("Morning", frozenset({("arm", "A-1")}), {"arm": same})
    (tmp_path / GAUGE).write_text("{}")
    uses = Uses({}, (in_use,), {("gauge", plate.name): tmp_path})
    assert not uses.note(arm, same)
    assert not uses.note(plate, same)
    assert "Morning" in in_english(uses.note(arm, other))
    assert "another version" in in_english(uses.note(plate, other))


def test_what_is_added_while_the_operator_chooses_is_chosen(station: Server) -> None:
    """Where nothing else can be meant; and nothing stands where the chosen one was retired."""
    station.close()
    own = rows(station, kind="object", retired=False)
    for row in own:
        post(station, "/retire", **reference(row)).raise_for_status()
    station.http.post("/api/flow/start").raise_for_status()
    station.do("confirm_devices")
    assert chosen(station)["object"] == ""
    assert chosen(station)["arm"]
    row = add(station, text_of(BLOCK), "mine.json")
    assert chosen(station)["object"] == "mine"
    post(station, "/retire", **reference(row)).raise_for_status()
    assert "mine" not in [one["id"] for one in options(station, "object")]
    for row in own:
        post(station, "/restore", **reference(row)).raise_for_status()
    station.close()


def options(server: Server, field: str) -> list[dict[str, Any]]:
    choices = server.flow()["picture"]["choices"]
    return next(list(one["options"]) for one in choices if one["field"] == field)


def chosen(server: Server) -> dict[str, str]:
    return {one["field"]: one["selected"] for one in server.flow()["picture"]["choices"]}


def test_who_may_what(station: Server) -> None:
    """A viewer looks and downloads; an operator who has control changes; the log says who."""
    store = station.context.store
    for name in ("viewer", "operator"):
        store.accounts.add(f"d {name}", Role[name], None)
    bodies = {
        name: store.login_sessions.begin(f"d {name}", "test") for name in ("viewer", "operator")
    }
    try:
        with httpx.Client(base_url=station.address, timeout=PATIENCE_S) as http:

            def ask(who: str, method: str, path: str, **body: object) -> tuple[int, str]:
                headers = {"Cookie": f"{cookie_for(station.port)}={bodies[who]}"}
                answer = http.request(method, f"/api/datasheets{path}", headers=headers, json=body)
                return answer.status_code, answer.json().get("code", "")

            assert ask("viewer", "GET", "")[0] == 200
            assert ask("viewer", "POST", "/check", text="") == (403, "role")
            for path in ("", "/retire", "/restore", "/block-certificate"):
                assert ask("viewer", "POST", path) == (403, "role")
            assert ask("operator", "POST", "/check", text=text_of(BLOCK))[0] == 200
            station.http.post("/api/control/take", json={"reason": "test"}).raise_for_status()
            assert ask("operator", "POST", "", text=text_of(BLOCK))[1] == "control"
        add(station, text_of(BLOCK), "block.json")
        noted = station.http.get("/api/audit").json()
        assert "objects/block.json" in json.dumps(noted)
    finally:
        for name in ("viewer", "operator"):
            store.accounts.remove(f"d {name}")


def test_a_block_is_certified_as_by_the_command(station: Server, tmp_path: Path) -> None:
    drawn = {**BLOCK, "standard_uncertainty_mm": None, "tolerance_mm": 0.1}
    row = add(station, text_of(drawn))
    faces = [(f"edge_{n}", f"edge_{n + 1}") for n in range(1, 8)]
    faces += [("front", "back"), ("base", "crest"), ("floor", "crest")]
    lengths = [9.01, 8.02, 6.0, 6.99, 6.03, 7.0, 5.0, 26.0, 27.02, 15.0]

    def table(lengths: list[float]) -> str:
        rows = [f"{a},{b},{mm},0.005" for (a, b), mm in zip(faces, lengths, strict=True)]
        return "\n".join(["from,to,distance_mm,standard_uncertainty_mm", *rows])

    def ask(readings: str, path: str = "") -> httpx.Response:
        body = {"file": row["file"], "version": row["version"], "certificate": "Workshop 4"}
        address = f"/api/datasheets/block-certificate{path}"
        return station.http.post(address, json={**body, "readings": readings})

    (tmp_path / "drawing.json").write_text(text_of(drawn))
    (tmp_path / "readings.csv").write_text(table(lengths))
    command = ("certificate", "block", tmp_path / "readings.csv", "--issued", "Workshop 4")
    files_of = ("--drawing", tmp_path / "drawing.json", "-o", tmp_path / "object.json")
    printed(*command, *files_of)
    made = json.loads((tmp_path / "object.json").read_text())
    found = ask(table(lengths)).raise_for_status().json()
    assert json.loads(found["document"]) == made
    assert found["faces"][1]["measured_mm"] == made["edges_x_mm"][1]
    assert ask(table(lengths), "/page").raise_for_status().content.startswith(b"%PDF")
    kept = add(station, found["document"], edited=row["version"])
    assert (kept["certificate"], kept["issued_on"]) == ("Workshop 4", made["issued_on"])
    late = add(station, text_of(made, issued_on="2999-01-01"), edited=kept["version"])
    assert "2999-01-01" in english(late["note"])
    assert code_of(ask(table(lengths)))[1] == "datasheet-changed"
    row = late
    swapped = ask(table([lengths[1], lengths[0], *lengths[2:]]))
    assert code_of(swapped)[1] == "readings-exchanged"


def test_the_words_are_those_of_the_command_line(station: Server, tmp_path: Path) -> None:
    path = tmp_path / "object.json"
    path.write_text(text_of(BLOCK, edges_x_mm=[-24, -15, -16, -1]))
    with pytest.raises(Exception, match="must ascend") as raised:
        ObjectFile.read(path)
    refused = post(station, name="object.json", text=path.read_text())
    assert str(raised.value).replace(str(path), "object.json").rstrip(".") == refused.json()[
        "detail"
    ].rstrip(".")
