"""Any commands with any arguments, in every guide and every step: never a fault of the program,
and after a restart everything stands as it stood before.

``--hypothesis-profile=long`` tries ten thousand commands, in about an hour.
"""

import asyncio
import json
import shutil
import tempfile
import uuid
from collections.abc import Iterator, Sequence
from contextlib import suppress
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import httpx
import pytest
from fastapi import FastAPI
from hypothesis import HealthCheck, settings
from hypothesis import strategies as st
from hypothesis.stateful import RuleBasedStateMachine, initialize, rule, run_state_machine_as_test
from starlette.types import ASGIApp

from crenel.gauges.guide_rules import RULES as OF_PERFORMANCE
from crenel.gauges.quick.guide.rules import RULES as OF_VERIFICATION
from crenel.guide.arm.rules import RULES as OF_ARM
from crenel.guide.calibration.rules import RULES as OF_CALIBRATION
from crenel.operations.context import Context
from crenel.server.application import build_app
from crenel.server.composition import open_context
from crenel.store.store import Store
from crenel_hardware.simulator.station import SimulatedStation
from tests.api.calibrated import use_truth
from tests.bench.faults.served import SMALL
from tests.gauges.quick.test_session import cloud
from tests.guide.builders import Row, capture_row, point_row
from tests.guide.stations import Station, closed

pytestmark = [pytest.mark.device, pytest.mark.soak]

Rows = Sequence[Row]
SEQUENCES, LONG_SEQUENCES, COMMANDS = 4, 850, 12
PURPOSES = ("check", "tip", "identify")
CHOICES = dict.fromkeys(("arm", "object", "sensor"), "simulated")
NAMES = {
    "flow": (*OF_CALIBRATION.commands, "nothing"),
    "arm": (*OF_ARM.commands, "nothing"),
    "performance": (*OF_PERFORMANCE.commands, "nothing"),
    "verify": (*OF_VERIFICATION.commands, "nothing"),
}
Q_RAD = [[0.1 * joint + 0.3 * n for joint in range(6)] for n in range(4)]
TOUCHED: Rows = [point_row(face, q) for face, q in zip(("crest", "front") * 2, Q_RAD, strict=True)]
PICTURES: Rows = [capture_row(), capture_row(laser=None)]
TEST = {"calibration_id": "true", "gauge": "ball", "positions": 1, "limits": {}}
LENGTHS = {**TEST, "test": "lengths", "gauge": "steps"}
CONFIRMED = ("step_confirmed", {"lengths": 2, "touches_each": 1})
ENDS: Rows = [
    ("touched", {"feature": feature, "place": 0, "reading": q})
    for feature, q in zip(("l1-1-1-0", "l1-1-1-1", "l1-1-2-0", "l1-1-2-1"), Q_RAD, strict=True)
]
SCANNED: Rows = [
    ("started", {**LENGTHS, "gauge": "bar", "by_scan": True}),
    ("step_confirmed", {"lengths": 1, "touches_each": 1, "by_scan": True}),
    *(
        ("touched", {"feature": f"l1-{repeat}-1-{end}", "place": 0, "reading": Q_RAD[0]})
        for repeat in (1, 2, 3)
        for end in (0, 1)
    ),
]
BAR_SCAN = ("scan_begun", {"place": 1, "repeat": 1, "length": 0})
PLAN_FROZEN = ("plan_frozen", {"plan_sha256": "0" * 64, "setup": {}})
PATTERN: Rows = [
    *[("started", TEST), ("step_confirmed", {})],
    *(
        ("touched", {"feature": "p1-pattern", "place": place, "reading": q})
        for place, q in enumerate(Q_RAD)
    ),
]
AT: dict[str, list[Rows]] = {
    "calibration": [
        [],
        [("started", {"choices": CHOICES, "step": "devices"})],
        [("started", {"choices": CHOICES, "step": "setup"})],
        [("started", {"choices": CHOICES, "step": "touch"}), *TOUCHED],
        [("started", {"choices": CHOICES, "step": "touch"}), *TOUCHED, ("touch_confirmed", {})],
        [("started", {"choices": CHOICES, "step": "touch"}), *TOUCHED, *PICTURES],
    ],
    "arm": [
        [],
        *(
            [("started", {"purpose": purpose, "arm": "simulated", "limit_um": None})]
            for purpose in PURPOSES
        ),
        [
            ("started", {"purpose": "identify", "arm": "simulated", "limit_um": 50.0}),
            ("seat_begun", {"name": "Seat 1", "artefact": {"kind": "seat"}}),
            ("points", {"q_rad": Q_RAD}),
        ],
        [
            ("started", {"purpose": "tip", "arm": "simulated", "limit_um": 50.0}),
            ("seat_begun", {"name": "Sphere 1", "artefact": {"kind": "sphere", "size_mm": 25.0}}),
            ("points", {"q_rad": Q_RAD}),
        ],
    ],
    "verify": [
        [],
        *(
            [("started", {"calibration_id": "true", "gauge": "plate"}), *rows]
            for rows in (
                [],
                [("gauge_confirmed", {}), *(("touched", {"q_rad": q}) for q in Q_RAD)],
                [("gauge_confirmed", {}), ("touch_skipped", {}), *cloud(1), *cloud(2)],
                [
                    *[("gauge_confirmed", {}), ("touch_skipped", {}), *cloud(1)],
                    ("clouds_confirmed", {}),
                ],
            )
        ),
    ],
    "performance": [
        [],
        [("started", TEST)],
        [("started", TEST), ("step_confirmed", {})],
        PATTERN,
        [*PATTERN, PLAN_FROZEN, ("step_confirmed", {})],
        [*PATTERN, *[("step_confirmed", {})] * 2, ("scan_begun", {"articulation": 1})],
        [*PATTERN, *[("step_confirmed", {})] * 3],
        [*PATTERN, *[("step_confirmed", {})] * 4],
        [("started", LENGTHS)],
        [("started", LENGTHS), CONFIRMED, *ENDS, PLAN_FROZEN],
        SCANNED,
        [*SCANNED, BAR_SCAN, ("scan_ended", {"number": 1})],
        [*SCANNED, BAR_SCAN],
    ],
}
FOLDERS = {"verify": "verifications", "performance": "performance"}

ANY_TEXT = st.text(st.characters(exclude_categories=()), max_size=8)
ANYTHING = st.recursive(
    st.one_of(st.none(), st.booleans(), st.integers(), st.floats(), ANY_TEXT),
    lambda inner: st.one_of(
        st.lists(inner, max_size=3), st.dictionaries(ANY_TEXT, inner, max_size=3)
    ),
    max_leaves=4,
)
LIKELY = st.sampled_from(
    ("simulated", "chessboard", "arm", "object", "crest", "setup", "touch", "gauge", "seat", "bar")
    + ("ball", "steps", "form-touch", "length-touch", "artefact", "moved")
    + ("sphere", "plate", 0, 1, 2, 3, 25.0, 0.001, True)
)
FIELDS = (
    *("field", "id", "face", "index", "number", "to", "all", "limit_um", "kind", "size_mm"),
    *("quantity", "a_um", "k", "b_um", "articulation", "reason"),
    *("repeat", "by_scan"),
)
ARGS = st.one_of(
    st.dictionaries(st.sampled_from(FIELDS), st.one_of(LIKELY, ANYTHING), max_size=3),
    st.dictionaries(ANY_TEXT, ANYTHING, max_size=2),
)
JSON = {"Content-Type": "application/json"}
PLATE = {"format": "crenel/nominal", "version": 1, "shape": "plane", "name": "Plate"}
BALL = {"format": "crenel/nominal", "version": 1, "shape": "sphere", "radius_mm": 12.5}
LENGTH_PARTS = [{"length_mm": mm, "standard_uncertainty_um": 1} for mm in (100, 300)]
STEPS: dict[str, object] = {
    "format": "crenel/length-standard",
    "version": 1,
    "kind": "step-gauge",
    "name": "Steps",
}
STEPS["lengths"] = LENGTH_PARTS
BAR = {**STEPS, "kind": "ball-bar", "sphere_diameter_mm": 25, "lengths": LENGTH_PARTS[1:]}


class InProcess:
    """Asks an application without a server and without its devices."""

    def __init__(self, app: ASGIApp) -> None:
        self._runner = asyncio.Runner()
        transport = httpx.ASGITransport(app, raise_app_exceptions=False)
        self._http = httpx.AsyncClient(transport=transport, base_url="http://127.0.0.1")

    def get(self, path: str) -> httpx.Response:
        return self._runner.run(self._http.get(path))

    def post(self, path: str, body: object) -> httpx.Response:
        content = json.dumps(body)  # with what is no valid text, and what is no number
        return self._runner.run(self._http.post(path, content=content, headers=JSON))

    def close(self) -> None:
        self._runner.run(self._http.aclose())
        self._runner.close()


class AnyCommands(RuleBasedStateMachine):
    """One data folder: commands, and restarts of the station on it."""

    def __init__(self, simulation: SimulatedStation, template: Path, app: FastAPI) -> None:
        super().__init__()
        self.app = app
        self.data = Path(tempfile.mkdtemp(prefix="any-"))
        shutil.copytree(template, self.data, dirs_exist_ok=True)
        self.parts = Station(simulation, self.data).parts

    @initialize(at=st.fixed_dictionaries({kind: st.sampled_from(AT[kind]) for kind in AT}))
    def begin(self, at: dict[str, Rows]) -> None:
        store = Store(self.data)
        for kind, rows in at.items():
            if rows:
                seed(store, kind, rows)
        store.close()
        self.open()

    def open(self) -> None:
        # the same routes for all: making them takes most of a start
        self.context: Context = open_context(self.parts)
        self.app.state.context = self.context
        self.http = InProcess(self.app)
        code = {"code": self.context.authenticator.code}
        self.http.post("/api/session/code", code).raise_for_status()
        assert not any(guide.unreadable_reason for guide in self.guides())

    def guides(self) -> tuple[Any, ...]:
        context = self.context
        return context.guide, context.arm_guide, context.verify_guide, context.performance_guide

    @rule(flow=st.sampled_from(sorted(NAMES)), data=st.data(), args=ARGS, stale=st.booleans())
    def command(self, flow: str, data: st.DataObject, args: object, stale: bool) -> None:
        body = {
            "name": data.draw(st.sampled_from(NAMES[flow])),
            "args": args,
            "rev": 0 if stale else self.http.get(f"/api/{flow}").json()["rev"],
            "key": uuid.uuid4().hex,
        }
        self.free_arm()
        answered(self.http.post(f"/api/{flow}/command", body), body)

    @rule(flow=st.sampled_from(sorted(NAMES)), purpose=st.sampled_from(PURPOSES))
    def start(self, flow: str, purpose: str) -> None:
        asked: dict[str, str] | None = {"purpose": purpose} if flow == "arm" else None
        if flow == "performance" and purpose == "tip":
            asked = {"test": "lengths"}
        self.free_arm()
        answered(self.http.post(f"/api/{flow}/start", asked), flow)

    def free_arm(self) -> None:
        """As people do who are asked, and agree."""
        activity = self.http.get("/api/activity").json()["activity"]
        if activity is not None:
            answered(self.http.post("/api/activity/end", {"id": activity["id"]}), activity)

    @rule()
    def restart(self) -> None:
        self.context.jobs.wait(20.0)
        before = [guide.state for guide in self.guides()]
        self.close()
        self.open()
        assert [guide.state for guide in self.guides()] == before
        for route in (*NAMES, "home", "arm/checks", "calibrations", "performances"):
            assert self.http.get(f"/api/{route}").status_code == 200

    def close(self) -> None:
        self.http.close()
        closed(self.context)

    def teardown(self) -> None:
        with suppress(AttributeError):  # nothing was begun
            self.restart()
            self.close()
        shutil.rmtree(self.data, ignore_errors=True)


def seed(store: Store, kind: str, rows: Rows) -> None:
    """A session as its guide would have left it, with the datasheets in its folder."""
    session_id = f"seeded-{kind}"
    store.journal.begin_session(session_id, kind)
    for row_kind, payload in rows:
        store.journal.append(session_id, row_kind, payload)
    folder = store.folder / FOLDERS.get(kind, "sessions") / session_id
    folder.mkdir(parents=True, exist_ok=True)
    for name in ("arm", "object", "sensor"):
        shutil.copy(store.folder / f"{name}s" / "simulated.json", folder / f"{name}.json")
    gauge = "plate"
    if kind == "performance":
        gauge = str(rows[0][1]["gauge"])
    shutil.copy(store.folder / "gauges" / f"{gauge}.json", folder / "gauge.json")
    active = store.calibrations.active()
    assert active is not None
    shutil.copy(active.file, folder / "calibration.json")


def answered(answer: httpx.Response, asked: object) -> None:
    assert answer.status_code < 500, (asked, answer.text)


@pytest.fixture(scope="module")
def simulation() -> Iterator[SimulatedStation]:
    with SimulatedStation(SMALL) as simulation:
        yield simulation


@pytest.fixture(scope="module")
def template(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return tmp_path_factory.mktemp("template")


@pytest.fixture(scope="module")
def app(simulation: SimulatedStation, template: Path) -> FastAPI:
    """The routes; ``template`` becomes a data folder with a calibration in use and gauges."""
    app = build_app(Station(simulation, template).parts)
    context = app.state.context
    use_truth(SimpleNamespace(simulation=simulation, context=context), "true")
    (template / "gauges").mkdir(exist_ok=True)
    for name, gauge in (("plate", PLATE), ("ball", BALL), ("steps", STEPS), ("bar", BAR)):
        (template / "gauges" / f"{name}.json").write_text(json.dumps(gauge))
    closed(context)
    return app


def test_any_commands(simulation: SimulatedStation, template: Path, app: FastAPI) -> None:
    long = settings().max_examples > settings.get_profile("default").max_examples

    class OfThisStation(AnyCommands):
        def __init__(self) -> None:
            super().__init__(simulation, template, app)

    run_state_machine_as_test(
        OfThisStation,
        settings=settings(
            max_examples=LONG_SEQUENCES if long else SEQUENCES,
            stateful_step_count=COMMANDS,
            deadline=None,
            database=None,
            derandomize=not long,
            suppress_health_check=list(HealthCheck),
        ),
    )
