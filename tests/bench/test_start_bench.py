"""What the bench of the start makes of its figures, on copies of the program that are scripts."""

from contextlib import nullcontext
from pathlib import Path
from types import SimpleNamespace

import pytest

from app.bench.station import start
from app.bench.station.start import Rounds, StartRow, columns, run, table
from app.bench.station.started import InstalledCopy, find_copy
from app.errors import OperationError

pytestmark = [pytest.mark.device, pytest.mark.soak]

COMPILES = """#!/bin/sh
if [ ! -e "$PYTHONPYCACHEPREFIX" ]; then sleep 0.3; mkdir "$PYTHONPYCACHEPREFIX"; fi
"""
"""As a program that is slow only while its caches are empty."""


def script(folder: Path, text: str) -> Path:
    place = folder / ".venv" / "bin" / "crenel"
    place.parent.mkdir(parents=True)
    place.write_text(text)
    place.chmod(0o755)
    return place


def test_cold_rounds_find_nothing_that_another_left_and_warm_ones_do(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    rested = SimpleNamespace(ready_s=lambda: 0.0, idle_mb=lambda: 200.0)
    monkeypatch.setattr(start, "_demo", lambda *_, **__: iter(()))
    monkeypatch.setattr(start, "DemoProcess", lambda *_: nullcontext(rested))
    monkeypatch.setattr(InstalledCopy, "size_mb", lambda self: 500.0)
    (tmp_path / "session" / "images").mkdir(parents=True)
    script(tmp_path / "one", COMPILES)
    copies = [find_copy("this", tmp_path / "one"), find_copy("against", tmp_path / "one")]
    rows = {row.measure: row for row in run(copies, Rounds(2, 2, 0), tmp_path / "session")}
    for copy in copies:
        for command in ("crenel --help", "crenel calibrate --method one-pose"):
            assert rows[f"cold: {command}"].figures[copy.name][1] > 0.3
            assert rows[f"warm: {command}"].figures[copy.name][1] < 0.3
    assert rows["idle station: RSS"].unit == rows["installed size"].unit == "MB"


def test_a_table_has_each_copy_beside_the_others() -> None:
    rows = [
        StartRow("cold: ready", "s", {"this": (2.0, 1.5, 3.0), "against": (90.0, 90.0, 90.0)}),
        StartRow("cold: devices lost", "", {"this": (0.0, 0.0, 0.0), "against": (3.0, 3.0, 3.0)}),
    ]
    assert table(rows) == [
        ("cold: ready", "2.00 s (1.50–3.00)", "90.00 s"),
        ("cold: devices lost", "0", "3"),
    ]
    copies = [InstalledCopy("this", Path("crenel")), InstalledCopy("against", Path("crenel"))]
    assert columns(copies) == ("measure", "this", "against")


def test_a_command_that_fails_is_reported_with_its_last_line(tmp_path: Path) -> None:
    executable = script(tmp_path, "#!/bin/sh\necho no such session >&2\nexit 1\n")
    with pytest.raises(OperationError, match="crenel calibrate failed: no such session"):
        find_copy("this", executable).seconds(tmp_path, "calibrate")


def test_a_copy_that_is_not_there_is_refused(tmp_path: Path) -> None:
    with pytest.raises(OperationError, match="no such program"):
        find_copy("against", tmp_path)
