"""Each test runs once, in its pool; soak tests run if they are asked for."""

import json
from pathlib import Path

import pytest

pytestmark = pytest.mark.device
pytest_plugins = "pytester"

CONFTEST = """
import json, os
from pathlib import Path
import pytest
from tests.running.pools import Controller, Worker, add_within, pytest_xdist_auto_num_workers

pytest_addoption = add_within

def pytest_configure(config):
    for mark in ("quick", "slow", "device", "soak"):
        config.addinivalue_line("markers", mark)
    started = not hasattr(config, "workerinput") and config.getoption("tx", None)
    config.pluginmanager.register((Controller if started else Worker)(config))

@pytest.fixture(scope="module")
def station():
    return os.getpid()

@pytest.fixture(autouse=True)
def ran(request):
    line = json.dumps([request.node.name, os.getpid(), os.getpriority(os.PRIO_PROCESS, 0)])
    with Path("ran.jsonl").open("a") as file:
        file.write(line + "\\n")
"""
FILES = {
    "test_quick": "def test_quick(): pass",
    "test_slow": """
import pytest
@pytest.mark.slow
def test_slow(): pass
@pytest.mark.device
def test_mixed(): pass
""",
    "test_device": """
import pytest, time
pytestmark = pytest.mark.device
@pytest.mark.parametrize("number", range(12))
def test_alone(number): time.sleep(0.2)
""",
    "test_station": """
import pytest
pytestmark = [pytest.mark.device]
def test_first(station): pass
def test_second(station): pass
@pytest.mark.soak
def test_soak(station): pass
""",
    "test_soak_file": """
import pytest
pytestmark = pytest.mark.soak
def test_flood(): pass
""",
}
USUAL = {"test_quick", "test_slow", "test_mixed", "test_first", "test_second"} | {
    f"test_alone[{number}]" for number in range(12)
}


@pytest.fixture
def project(pytester: pytest.Pytester, monkeypatch: pytest.MonkeyPatch) -> pytest.Pytester:
    monkeypatch.setenv("PYTEST_DISABLE_PLUGIN_AUTOLOAD", "1")
    pytester.makeini(f"[pytest]\npythonpath = {Path(__file__).parents[2]}")
    pytester.makeconftest(CONFTEST)
    pytester.makepyfile(**FILES)
    return pytester


def run(
    project: pytest.Pytester, *options: str
) -> tuple[pytest.RunResult, list[tuple[str, int, int]]]:
    """What pytest says, and each test that ran with its process and the priority of that."""
    record = project.path / "ran.jsonl"
    record.unlink(missing_ok=True)
    result = project.runpytest_subprocess("-p", "xdist", *options)
    lines = record.read_text().splitlines() if record.exists() else []
    return result, [tuple(json.loads(line)) for line in lines]


def test_each_test_runs_once_in_its_pool(project: pytest.Pytester) -> None:
    result, ran = run(project, "-n", "auto")
    assert result.ret == 0
    assert sorted(name for name, _, _ in ran) == sorted(USUAL)
    of = {name: (process, nice) for name, process, nice in ran}
    lowest = min(nice for _, nice in of.values())
    assert {name for name, (_, nice) in of.items() if nice > lowest} == {"test_quick", "test_slow"}
    assert of["test_first"] == of["test_second"]
    assert len({of[f"test_alone[{number}]"] for number in range(12)}) > 1


@pytest.mark.parametrize("workers", ["0", "1", "3"])
def test_any_number_of_workers_runs_all(project: pytest.Pytester, workers: str) -> None:
    result, ran = run(project, "-n", workers)
    assert result.ret == 0
    assert sorted(name for name, _, _ in ran) == sorted(USUAL)


@pytest.mark.parametrize(
    ("asked", "expected"),
    [
        (("-m", "soak"), {"test_soak", "test_flood"}),
        (("-m", "quick"), {"test_quick"}),
        (("-k", "flood"), {"test_flood"}),
        (("test_soak_file.py",), {"test_flood"}),
        (("test_station.py",), {"test_first", "test_second", "test_soak"}),
        (("test_quick.py", "test_slow.py"), {"test_quick", "test_slow", "test_mixed"}),
    ],
)
def test_who_asks_for_a_test_gets_it(
    project: pytest.Pytester, asked: tuple[str, ...], expected: set[str]
) -> None:
    result, ran = run(project, "-n", "auto", *asked)
    assert result.ret == 0
    assert {name for name, _, _ in ran} == expected


def test_no_test_is_begun_after_the_end(project: pytest.Pytester) -> None:
    result, ran = run(project, "-n", "auto", "--within", "0")
    assert result.ret == 0
    assert not ran
    result.stdout.fnmatch_lines([f"{len(USUAL)} tests were not begun in time, of *test_slow.py*"])


def test_nothing_chosen_ends_as_without_pools(project: pytest.Pytester) -> None:
    result, ran = run(project, "-n", "auto", "-k", "no_such_name")
    assert result.ret == pytest.ExitCode.NO_TESTS_COLLECTED
    assert not ran


def test_the_rest_of_a_worker_that_ends_is_run_by_others(project: pytest.Pytester) -> None:
    project.makepyfile(
        test_station="""
import os, pytest
pytestmark = [pytest.mark.device]
def test_first(station): os._exit(3)
def test_second(station): pass
"""
    )
    result, ran = run(project, "-n", "auto")
    assert result.ret == pytest.ExitCode.TESTS_FAILED
    assert sorted(name for name, _, _ in ran) == sorted(USUAL)
    result.stdout.fnmatch_lines(["*crashed while running*test_first*"])
