"""The table [sign_in] of station.toml, and sign-ins between beginning and end."""

from pathlib import Path
from typing import Any

import pytest
from pydantic import ValidationError

from crenel.settings.settings import Settings
from crenel.single_sign_on.errors import SignInError
from crenel.single_sign_on.pending import LASTS_S, PendingSignIns
from crenel.single_sign_on.settings import SECRET_VARIABLE
from tests.refusals import refused_as
from tests.single_sign_on.mock_provider import read_table

TABLE: dict[str, Any] = {
    "name": "Keycloak",
    "issuer": "https://sso.example.org/realms/plant",
    "client_id": "station-2",
    "roles": {"operators": "operator"},
}


def test_the_table_is_read_with_its_defaults(tmp_path: Path) -> None:
    read = Settings.model_validate({"sign_in": TABLE}, context=tmp_path / "station.toml").sign_in
    assert read is not None
    assert read.scopes == ("openid", "profile")
    assert read.client_secret({}) is None
    assert read.client_secret({SECRET_VARIABLE: "from the environment"}) == "from the environment"
    (tmp_path / "secret").write_text("from the file\n")
    read = read_table(tmp_path, TABLE | {"client_secret_file": "secret"})
    assert read.client_secret({SECRET_VARIABLE: "from the environment"}) == "from the file"


@pytest.mark.parametrize(
    ("wrong", "named"),
    [
        ({"issuer": "http://sso.example.org"}, "issuer"),
        ({"issuer": "https://"}, "issuer"),
        ({"issuer": "https://[sso"}, "issuer"),
        ({"issuer": "https://sso.example.org?realm=plant"}, "issuer"),
        ({"scopes": ["profile"]}, "scopes"),
        ({"ca_file": "no-such-file"}, "ca_file"),
        ({"ca_file": "station.toml"}, "ca_file"),
        ({"client_secret_file": "no-such-file"}, "no-such-file"),
    ],
)
def test_what_cannot_work_is_named(tmp_path: Path, wrong: dict[str, object], named: str) -> None:
    (tmp_path / "station.toml").write_text("no certificate")
    with refused_as("settings-sign-in", named):
        read_table(tmp_path, TABLE | wrong)


@pytest.mark.parametrize(
    "wrong",
    [
        {"roles": {}},
        {"roles": {"operators": "owner"}},
        {"client_secret": "in the file itself"},
        {"sign_out": "nowhere"},
    ],
)
def test_what_is_no_such_table_is_refused(tmp_path: Path, wrong: dict[str, object]) -> None:
    with pytest.raises(ValidationError):
        read_table(tmp_path, TABLE | wrong)


def test_a_sign_in_ends_after_its_time() -> None:
    now = 1000.0
    pending = PendingSignIns(lambda: now)
    first, second = pending.begin(), pending.begin()
    assert len({first.state, first.nonce, first.verifier, second.state, second.nonce}) == 5
    now += LASTS_S - 1
    assert pending.finish(first.cookie, first.state) == first
    now += 2
    with pytest.raises(SignInError):
        pending.finish(second.cookie, second.state)


def test_a_crowd_pushes_no_sign_in_out() -> None:
    pending = PendingSignIns()
    first = pending.begin()
    for _ in range(20_000):
        pending.begin()
    assert pending.finish(first.cookie, first.state) == first
    with pytest.raises(SignInError):
        pending.finish(first.cookie, first.state)
