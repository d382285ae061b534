"""The scripts of CI: what they run, in which order, and what becomes of a failure."""

import os
import re
import shutil
import subprocess
from collections.abc import Callable
from pathlib import Path

import pytest
import yaml

from tests.sources import ROOT

pytestmark = pytest.mark.device
STARTED_MODULES = ()  # scripts, with stubs of what they call

CONTRIBUTING = ROOT / "CONTRIBUTING.md"
CHECK = re.compile(r"\.venv/bin/(?:ruff|mypy)(?: [\w.-]+)*")
OF_THE_SYSTEM = (
    *("chromium", "mosquitto", "nginx", "arv-fake-gv-camera-0.8", "avr-gcc"),
    *("apt-get", "python3"),
)
OF_THE_ENVIRONMENT = ("pip", "pytest", "python", "ruff", "mypy")
PARTS = ("figures", "sanitize", "cross")
STUB = """#!/usr/bin/env bash
called="$(basename "$0")${{*:+ $*}}"
echo "$called" >>calls
case $called in
"python3 -m venv .venv") mkdir .venv && cp -r programs .venv/bin ;;
{answers}
esac
"""
REACH = "python -m tests.running.reach"
TWO_REACHED = f'"{REACH}") echo tests/a/test_a.py; echo tests/b/test_b.py ;;'
SOAK = "pytest -m soak --within 900 tests/a/test_a.py tests/b/test_b.py"

Ran = tuple[subprocess.CompletedProcess[str], list[str]]
Script = Callable[..., Ran]


@pytest.fixture
def script(tmp_path: Path) -> Script:
    """Runs a script of CI where each program notes its call, and does what ``answers`` has as a
    ``case``."""

    def run(name: str, *arguments: str, answers: str = "") -> Ran:
        stub = STUB.format(answers=answers)
        stubs = {"bin": OF_THE_SYSTEM, "programs": OF_THE_ENVIRONMENT, ".ci": PARTS}
        for folder, programs in (stubs | {".venv/bin": OF_THE_ENVIRONMENT}).items():
            (tmp_path / folder).mkdir(parents=True)
            for program in programs:
                (tmp_path / folder / program).write_text(stub)
                (tmp_path / folder / program).chmod(0o755)
        for file in ("README.md", f".ci/{name}"):
            shutil.copy(ROOT / file, tmp_path / file)
        done = subprocess.run(
            [tmp_path / ".ci" / name, *arguments],
            env=os.environ | {"PATH": f"{tmp_path / 'bin'}{os.pathsep}{os.environ['PATH']}"},
            capture_output=True,
            text=True,
            check=False,
        )
        return done, (tmp_path / "calls").read_text().splitlines()

    return run


def test_the_hooks_run_what_ci_runs() -> None:
    config = yaml.safe_load((ROOT / ".pre-commit-config.yaml").read_text("utf-8"))
    hooks = [hook["entry"] for repo in config["repos"] for hook in repo["hooks"]]
    assert hooks == CHECK.findall((ROOT / ".ci/run").read_text("utf-8"))


def test_the_tests_that_are_named_exist() -> None:
    for file in (CONTRIBUTING, *(ROOT / ".ci").iterdir()):
        for named in re.findall(r"\btests/[\w./{,}]+", file.read_text("utf-8")):
            before, *braces = re.split(r"[{}]", named.rstrip(".,"))
            choices, after = braces or ("", "")
            for choice in choices.split(","):
                path = f"{before}{choice}{after}"
                assert (ROOT / path).exists(), f"{file.name} names {path}"


def test_a_landing_runs_checks_tests_and_the_soak_tests_that_it_reaches(script: Script) -> None:
    done, calls = script("run", answers=TWO_REACHED)
    assert done.returncode == 0, done.stderr
    calls = [call for call in calls if not call.startswith("apt-get")]
    calls.remove("mypy")  # beside the tests
    checks = ["ruff check .", "ruff format --check ."]
    install = ["python3 -m venv .venv", "pip install -e .[dev]"]
    assert calls == [*install, *checks, "pytest", REACH, SOAK]


def test_a_landing_that_reaches_no_soak_test_says_so(script: Script) -> None:
    done, calls = script("run")
    assert done.returncode == 0
    assert calls[-1] == REACH
    assert "No soak test is reached" in done.stdout


def test_a_slow_machine_leaves_soak_tests_to_the_night(
    script: Script, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("SLOW_S", "-1")
    done, calls = script("run", answers=TWO_REACHED)
    assert done.returncode == 0
    assert calls[-1] == REACH
    assert "This machine is too slow" in done.stdout


def test_soak_tests_that_need_what_is_missing_fail_no_landing(script: Script) -> None:
    done, _ = script("run", answers=f'{TWO_REACHED}\n"{SOAK}") exit 5 ;;')
    assert done.returncode == 0
    assert "needs what is not installed here" in done.stdout


@pytest.mark.parametrize("failing", ["ruff check .", "mypy", "pytest", REACH, SOAK])
def test_whatever_fails_fails_the_landing(script: Script, failing: str) -> None:
    answers = f'"{failing}") echo "a reason"; exit 1 ;;\n{TWO_REACHED}'
    done, calls = script("run", answers=answers)
    assert done.returncode != 0
    if failing != REACH:  # its output names tests
        assert "a reason" in done.stdout
    assert (REACH in calls) == (failing in (REACH, SOAK))


def test_the_nightly_parts_run_whatever_became_of_the_others(script: Script) -> None:
    done, calls = script("nightly", answers="figures) exit 3 ;;\npytest*soak*) exit 1 ;;")
    assert done.returncode == 1
    assert calls == [
        *(
            "pytest -m soak or not soak",
            "pytest -m hypothesis --hypothesis-profile=long --timeout=0",
        ),
        *("figures", "sanitize", "cross", "python3 .ci/installs.py", "python3 .ci/container.py"),
    ]
    line = r"^(\w+) +(passed|failed with status \d+) after 0 min$"
    said = dict(re.findall(line, done.stdout, re.MULTILINE))
    assert said.pop("tests") == "failed with status 1"
    assert said.pop("figures") == "failed with status 3"
    passed = ("properties", "sanitize", "cross", "installs", "container")
    assert list(said.items()) == [(name, "passed") for name in passed]


def test_the_nightly_parts_are_documented() -> None:
    table = CONTRIBUTING.read_text("utf-8").split("\n| part | does |\n")[1].split("\n\n")[0]
    script = (ROOT / ".ci/nightly").read_text("utf-8")
    (parts,) = re.findall(r"^parts=\((.*)\)$", script, re.MULTILINE)
    assert re.findall(r"^\| `(\w+)` \|", table, re.MULTILINE) == parts.split()


def test_parts_of_the_night_can_be_named(script: Script) -> None:
    done, calls = script("nightly", "cross", "figures")
    assert (done.returncode, calls) == (0, ["cross", "figures"])


def test_a_part_that_does_not_exist_fails(script: Script) -> None:
    done, calls = script("nightly", "moon", "cross")
    assert (done.returncode, calls) == (1, ["cross"])
    assert "there is no part moon" in done.stderr
