"""The guided inspection over HTTP at a simulated station: its steps, what it declines, what is the
same by the command."""

import json
import shutil
import zipfile
from collections.abc import Iterator
from dataclasses import replace
from io import BytesIO
from pathlib import Path

import pytest
from typer.testing import CliRunner

from crenel.cli.main import cli
from crenel.parts.document_results import InspectionFile
from crenel_hardware.simulator.operator.gauges.part import MADE
from tests.api.conftest import Server, View, comes, refusal
from tests.api.desks import GuideDesk, left_in_order
from tests.bench.faults.served import SMALL
from tests.parts.known_calibration import add_covariance
from tests.sent_texts import english

pytestmark = pytest.mark.device

STATION = replace(SMALL, pace=12.0)
DATUMS = ("A", "B", "C")


class PartDesk(GuideDesk):
    path = "/api/parts"

    def start(self) -> View:
        self.close()
        self.http.post("/api/parts/start").raise_for_status()
        return self.view()

    def touch(self, feature: str, index: int) -> bool:
        """Touches a place by the arm's button; False where it was declined."""
        guide = self.server.context.part_guide
        with guide.lock:
            before, declined = len(guide.state.counted), guide.declined
        assert self.server.simulation.operator.touch_part(feature, index)
        comes(lambda: len(guide.state.counted) > before or guide.declined > declined)
        return len(guide.state.counted) > before

    def touch_all(self, feature: str, count: int) -> View:
        """Touches places of a feature until so many are taken; a busy machine's arm may come
        late."""
        index = taken = 0
        while taken < count:
            taken += self.touch(feature, index)
            index += 1
            assert index < 3 * count, self.view()["findings"]
        return self.view()

    def align(self) -> View:
        self.start()
        self.do("name_part", serial_number="P-17", operator="Ada")
        self.do("confirm_setup")
        for name in DATUMS:
            self.do("choose_feature", id=name)
            self.touch_all(name, 4)
        return self.do("confirm")


@pytest.fixture
def desk(server: Server, calibration: str) -> Iterator[PartDesk]:
    active = server.context.store.calibrations.active()
    assert active is not None
    add_covariance(active.file)
    with left_in_order(PartDesk(server)) as desk:
        yield desk


def mark(view: View, name: str) -> View:
    return dict(next(one for one in view["features"] if one["id"] == name))


def test_a_feature_is_measured_with_u_as_it_is_touched(desk: PartDesk) -> None:
    view = desk.align()
    assert (view["step"], view["feature"]) == ("measure", "D")
    assert "known to" in english(view["frame"])
    view = desk.do("choose_feature", id="H2")
    view = desk.touch_all("H2", 6)
    (diameter,) = (one for one in view["dimensions"] if one["id"] == "d-H2")
    true = MADE.bores[1][2]
    assert abs(diameter["value"] - true) < 2 * diameter["expanded"]
    assert diameter["decision"] == mark(view, "H2")["outcome"] == "fail"
    assert diameter["scatter"] is None
    assert len(view["touches"]) == 6
    assert all(abs(one["residual_um"]) < 100 for one in view["touches"])
    # what is taken back is not measured any more, and can be put back
    assert desk.do("undo")["dimensions"] == []
    again = desk.do("redo")
    assert [one["id"] for one in again["dimensions"]] == [one["id"] for one in view["dimensions"]]
    assert desk.do("retake_feature", id="H2")["touches"] == []


def test_a_touch_of_another_feature_is_declined_and_named(desk: PartDesk) -> None:
    desk.align()
    desk.do("choose_feature", id="H1")
    assert desk.touch("H1", 0)
    assert not desk.touch("pin", 0)
    view = desk.view()
    assert "pin" in english(view["findings"][0]["text"])
    assert mark(view, "H1")["touches"] == 1
    assert "Still to be touched" in refusal(desk.command("confirm"))
    assert "datum" in refusal(desk.command("skip_feature", id="A", reason="damaged"))


def test_programs_are_checked_whole(desk: PartDesk) -> None:
    desk.start()
    file = desk.server.data / "programs" / "example-plate.json"
    program = json.loads(file.read_text())
    program["dimensions"][0]["features"] = ["C", "nothing"]
    sent = {"name": "wrong.json", "text": json.dumps(program)}
    assert "nothing" in refusal(desk.http.post("/api/parts/programs", json=sent))
    assert not (file.parent / "wrong.json").exists()
    program["dimensions"] = []
    program["source"] = {"default": "scan"}
    sent = {"name": "scans.json", "text": json.dumps(program)}
    view = desk.http.post("/api/parts/programs", json=sent).json()
    assert view["program"] == "scans"
    assert "scan of" in refusal(desk.command("confirm_setup"))
    sent["text"] += " "
    assert "already" in refusal(desk.http.post("/api/parts/programs", json=sent))
    (file.parent / "scans.json").unlink()


@pytest.mark.soak
def test_the_folder_gives_the_same_result_by_the_command(desk: PartDesk, tmp_path: Path) -> None:
    desk.align()
    for name in ("D", "E", "H1", "H2", "pin", "ball", "slot"):
        desk.do("choose_feature", id=name)
        desk.touch_all(name, mark(desk.view(), name)["least"] + 1)
    desk.do("skip_feature", id="sink", reason="burr")
    desk.do("skip_feature", id="S", reason="unmilled")
    desk.do("confirm")
    view = desk.wait(lambda view: view["result"] is not None)
    assert view["result"]["verdict"] == "fail"
    session = view["session_id"]
    packed = desk.http.get(f"/api/parts/inspections/{session}/folder.zip").content
    desk.do("accept")
    (listed, *_) = desk.http.get("/api/parts/inspections").json()
    assert (listed["id"], listed["serial_number"], listed["operator"]) == (session, "P-17", "Ada")
    assert listed["failed"] >= 1
    with zipfile.ZipFile(BytesIO(packed)) as file:
        file.extractall(tmp_path)
    folder = tmp_path / f"inspection-{session}"
    stored = (folder / "results.json").read_bytes()
    moved = shutil.copytree(folder, tmp_path / "elsewhere")
    (moved / "results.json").unlink()
    ended = CliRunner().invoke(cli, ["inspect", str(moved)])
    assert ended.exit_code == 4, ended.output
    assert (moved / "results.json").read_bytes() == stored
    assert desk.http.get(f"/api/parts/inspections/{session}").content == stored
    found = InspectionFile.read(moved / "results.json")
    assert set(found.not_measured) == {"step", "angle-sink"}
    assert "burr" in " ".join(str(one) for one in found.warnings)
