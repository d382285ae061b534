"""Smoke test of an installed Crenel, in a folder of its own and with nothing of the checkout.

``python3 .ci/smoke.py COMMAND``, where COMMAND is the installed ``crenel``: it answers for itself,
its packages are imported beside a foreign ``app``, the demonstration is served and ends in order,
and a simulated session is calibrated, extracted and reported.
"""

import argparse
import os
import signal
import subprocess
import sys
import tempfile
import time
from http.client import HTTPConnection
from pathlib import Path
from urllib.parse import urlsplit

PATIENCE_S = 240.0
IMPORT = """\
import app, hardware  # of the folder's own
import crenel
from crenel import extract_stripe
from crenel_hardware.interfaces import Frame
assert all(getattr(crenel, name) for name in crenel.__all__)
"""
RENDER = """\
from pathlib import Path
from crenel_hardware.simulator.session import SessionPlan, render_session
render_session(Path("session"), 7, SessionPlan())
"""


class SmokeError(Exception):
    """The installation did not do what it should."""


def run(*command: str, folder: Path) -> str:
    """What a command prints.

    Raises:
        SmokeError: it failed; the message holds all that it printed.
    """
    began = time.monotonic()
    done = subprocess.run(
        command, cwd=folder, capture_output=True, text=True, timeout=PATIENCE_S, check=False
    )
    if done.returncode:
        raise SmokeError(f"{' '.join(command)} ended with {done.returncode}\n{done.stderr}")
    print(f"  {time.monotonic() - began:5.1f} s  {' '.join(command[1:3])}", flush=True)
    return done.stdout


def check_demo(crenel: str, folder: Path) -> None:
    """The demonstration serves its page, and SIGTERM ends it in order.

    Raises:
        SmokeError: the page does not come, or the process does not end.
    """
    began = time.monotonic()
    errors = folder / "demo-errors.txt"
    command = [crenel, "demo", "--no-open", "--port", "0", "--data", str(folder / "data")]
    with (
        errors.open("w") as said,
        subprocess.Popen(
            command, cwd=folder, stdout=subprocess.PIPE, stderr=said, text=True
        ) as process,
    ):
        try:
            assert process.stdout is not None
            words = (word for line in process.stdout for word in line.split())
            address = next((word for word in words if word.startswith("http")), "")
            if not address:
                raise SmokeError(f"crenel demo did not start\n{errors.read_text()}")
            for path, what in (("/", "first page"), ("/api/session", "ready")):
                await_answer(address, path)
                print(f"  {time.monotonic() - began:5.1f} s  demo: {what}", flush=True)
            process.send_signal(signal.SIGTERM)
            process.wait(15.0)
        finally:
            process.kill()
    if process.returncode not in (0, 128 + signal.SIGTERM):
        raise SmokeError(f"crenel demo ended with {process.returncode}\n{errors.read_text()}")
    if "Traceback" in errors.read_text():
        raise SmokeError(f"crenel demo did not end in order\n{errors.read_text()}")


def await_answer(address: str, path: str) -> None:
    """Waits until something is served there.

    Raises:
        SmokeError: it is not, in time.
    """
    where = urlsplit(address)
    deadline = time.monotonic() + PATIENCE_S
    while time.monotonic() < deadline:
        try:
            if status_of(str(where.hostname), int(where.port or 80), path) == 200:
                return
        except OSError:
            pass  # its socket may not listen yet
        time.sleep(0.1)
    raise SmokeError(f"{address} does not answer at {path}")


def status_of(host: str, port: int, path: str) -> int:
    connection = HTTPConnection(host, port, timeout=5.0)
    try:
        connection.request("GET", path)
        return connection.getresponse().status
    finally:
        connection.close()


def check_import(crenel: str, folder: Path) -> None:
    """The packages are imported beside others that are named like the project's folders.

    Raises:
        SmokeError: they are not.
    """
    foreign = folder / "foreign"
    for name in ("app", "hardware"):
        (foreign / name).mkdir(parents=True)
        (foreign / name / "__init__.py").touch()
    run(python_of(crenel), "-c", IMPORT, folder=foreign)


def python_of(crenel: str) -> str:
    """The interpreter that the command was installed for."""
    return str(Path(crenel).resolve().with_name("python"))


def check_session(crenel: str, folder: Path) -> None:
    """A simulated session is rendered, calibrated, extracted and reported.

    Raises:
        SmokeError: a command fails, or leaves no result.
    """
    (folder / "render.py").write_text(RENDER)
    run(python_of(crenel), "render.py", folder=folder)
    session = folder / "session"
    run(crenel, "calibrate", str(session), "-o", str(session / "calibration.json"), folder=folder)
    picture = next((session / "images").glob("*laser*"))
    run(crenel, "extract", str(picture), "-o", "stripe.csv", folder=folder)
    run(crenel, "report", str(session), "-o", "report.pdf", folder=folder)
    columns = len((folder / "stripe.csv").read_text().splitlines()) - 1
    if columns < 100:
        raise SmokeError(f"only {columns} columns of the stripe were extracted")


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("command", help="the installed crenel")
    crenel = str(Path(parser.parse_args().command).absolute())
    os.environ.pop("PYTHONPATH", None)
    with tempfile.TemporaryDirectory(prefix="crenel-smoke-") as name:
        folder = Path(name)
        try:
            print(f"  {run(crenel, '--version', folder=folder).strip()}")
            if "calibrate" not in run(crenel, "--help", folder=folder):
                raise SmokeError("crenel --help does not list its commands")
            check_import(crenel, folder)
            check_demo(crenel, folder)
            check_session(crenel, folder)
        except SmokeError as error:
            sys.exit(f"smoke: {error}")


if __name__ == "__main__":
    main()
