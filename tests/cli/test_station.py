"""``crenel backup``, ``password`` and ``mqtt-schema``."""

import json
from pathlib import Path

from jsonschema import Draft202012Validator
from typer.testing import CliRunner, Result

from crenel.cli.main import cli
from crenel.store.accounts import Role
from crenel.store.store import Store


def test_a_folder_in_use_is_backed_up_and_can_be_opened(tmp_path: Path) -> None:
    store = Store(tmp_path / "data")
    (store.folder / "arms/arm.json").write_text("{}")
    words = ["backup", str(store.folder), "--output", str(tmp_path / "copy"), "--json"]
    done = CliRunner().invoke(cli, words)
    assert done.exit_code == 0, done.output
    assert json.loads(done.stdout)["files"] == 2
    again = CliRunner().invoke(cli, words)
    assert again.exit_code == 1
    assert "already exists" in again.output
    copy = Store(tmp_path / "copy")
    assert (copy.folder / "arms/arm.json").read_text() == "{}"
    copy.close()
    store.close()


def test_a_forgotten_password_is_replaced_beside_a_station_that_runs(tmp_path: Path) -> None:
    store = Store(tmp_path)
    store.accounts.add("Ada", Role.admin, "a password that is lost")
    cookie = store.login_sessions.begin("Ada", "a browser")

    def give(name: str, password: str) -> Result:
        return CliRunner().invoke(cli, ["password", str(tmp_path), name], input=f"{password}\n")

    assert give("Eve", "three unrelated words").exit_code == 1
    assert "accounts: Ada" in give("Eve", "three unrelated words").output
    assert "10 to 200 are required" in give("ada", "short").output
    done = give("ada", "three unrelated words")
    assert (done.exit_code, "Ada has a new password" in done.output) == (0, True)
    assert store.accounts.authenticate("Ada", "three unrelated words")
    assert store.login_sessions.principal(cookie) is None
    assert store.audit.newest(1)[0].act == "changed an account: Ada, new password"
    store.close()
    nowhere = CliRunner().invoke(cli, ["password", str(tmp_path / "none"), "Ada"])
    assert "not the data folder of a station" in nowhere.output


def test_the_schema_is_printed() -> None:
    done = CliRunner().invoke(cli, ["mqtt-schema"])
    assert done.exit_code == 0
    schema = json.loads(done.stdout)
    Draft202012Validator.check_schema(schema)
    assert "PREFIX/STATION/report" in schema["topics"]
