"""A test that leaves something is named, and only that one."""

import textwrap
from pathlib import Path

import pytest

pytestmark = pytest.mark.device
pytest_plugins = "pytester"

CONFTEST = """
import pytest
from tests.running import leaks
leaks.GRACE_S = 0.3

def pytest_configure(config):
    config.pluginmanager.register(leaks.LeakCheck(), "check")

@pytest.fixture(scope="session", autouse=True)
def begin(request, tmp_path_factory):
    request.config.pluginmanager.get_plugin("check").begin(tmp_path_factory.mktemp("t") / "t")
"""
LEAVING = """
import socket, subprocess, tempfile, threading
import pytest

kept = []

def test_leaves_a_thread():
    kept.append(threading.Event())
    threading.Thread(target=kept[0].wait, args=(20,), name="left-behind", daemon=True).start()

def test_leaves_a_process():
    kept.append(subprocess.Popen(["sleep", "20"]))

def test_leaves_a_socket():
    kept.append(socket.socket())

def test_leaves_a_file():
    kept.append(tempfile.mkdtemp(prefix="left-behind"))

def test_leaves_nothing():
    with socket.socket():
        pass

@pytest.fixture(scope="module")
def server():
    with socket.socket() as listening:
        yield listening

def test_uses_what_its_module_shares(server):
    kept.append(socket.socket())

def test_is_the_last_of_its_module(server):
    kept.pop().close()

def test_waits_for_what_ends_by_itself():
    threading.Thread(target=kept[0].wait, args=(0.05,)).start()

def test_ends_what_the_others_left():
    kept[0].set()
    kept[1].kill()
    kept[1].wait()
    kept[2].close()
"""


def test_the_test_that_leaves_something_is_named(pytester: pytest.Pytester) -> None:
    root = Path(__file__).parents[2]
    pytester.makeconftest(CONFTEST)
    pytester.makepyfile(textwrap.dedent(LEAVING))
    pytester.makeini(f"[pytest]\npythonpath = {root}")
    result = pytester.runpytest_subprocess("-p", "no:randomly", "-p", "no:cacheprovider")
    named = [line for line in result.outlines if line.startswith("ERROR ")]
    assert [line.split("::")[1].split(" ")[0] for line in named] == [
        "test_leaves_a_thread",
        "test_leaves_a_process",
        "test_leaves_a_socket",
        "test_leaves_a_file",
    ]
    result.assert_outcomes(passed=9, errors=4)
    result.stdout.fnmatch_lines(["*leaves threads:*left-behind*", "*leaves files:*left-behind*"])
