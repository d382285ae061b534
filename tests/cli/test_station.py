"""``crenel backup`` and ``crenel mqtt-schema``."""

import json
from pathlib import Path

from jsonschema import Draft202012Validator
from typer.testing import CliRunner

from app.cli import cli
from app.store.store import Store


def test_a_folder_in_use_is_backed_up_and_can_be_opened(tmp_path: Path) -> None:
    store = Store(tmp_path / "data")
    (store.folder / "arms/arm.json").write_text("{}")
    words = ["backup", str(store.folder), "--output", str(tmp_path / "copy"), "--json"]
    done = CliRunner().invoke(cli, words)
    assert done.exit_code == 0, done.output
    assert json.loads(done.stdout)["files"] == 2
    again = CliRunner().invoke(cli, words)
    assert again.exit_code == 1
    assert "is there already" in again.output
    copy = Store(tmp_path / "copy")
    assert (copy.folder / "arms/arm.json").read_text() == "{}"
    copy.close()
    store.close()


def test_the_schema_is_printed() -> None:
    done = CliRunner().invoke(cli, ["mqtt-schema"])
    assert done.exit_code == 0
    schema = json.loads(done.stdout)
    Draft202012Validator.check_schema(schema)
    assert "PREFIX/STATION/report" in schema["topics"]
