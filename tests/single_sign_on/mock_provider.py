"""The provider of the package oidc-provider-mock, in a process of its own."""

import subprocess
import sys
import time
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass
from importlib.util import find_spec
from pathlib import Path
from urllib.parse import parse_qsl, urlsplit

import httpx
import pytest

from crenel.single_sign_on.pending import ProviderAnswer
from crenel.single_sign_on.settings import SignInSettings
from tests.bench.station.subprocess_station import free_port

STARTED_MODULES = ()  # a provider of others
PATIENCE_S = 60.0
BACK = "http://127.0.0.1:9/sign-in"
ROLES = {"sensor-viewers": "viewer", "sensor-operators": "operator", "sensor-admins": "admin"}


SIGN_IN = """
[sign_in]
name = "Keycloak"
issuer = "{issuer}"
client_id = "{client}"
client_secret_file = "secret"

[sign_in.roles]
"measuring-room" = "operator"
"""
"""For a settings file, with the issuer and the client's id to be filled in; the file ``secret`` is
beside it."""


@dataclass
class MockProvider:
    """A running provider, and one client that is registered there."""

    issuer: str
    client_id: str = ""
    secret: str = ""

    def register(self, *backs: str) -> None:
        """Registers a client with these redirect URIs."""
        answer = httpx.post(f"{self.issuer}/oauth2/clients", json={"redirect_uris": backs})
        made = answer.raise_for_status().json()
        self.client_id, self.secret = made["client_id"], made["client_secret"]

    def put(self, subject: str, **claims: object) -> None:
        """Creates a person, or changes the claims of one."""
        httpx.put(f"{self.issuer}/users/{subject}", json=claims).raise_for_status()

    def settings(self, folder: Path, **others: object) -> SignInSettings:
        """Those of a station that is this client."""
        client = {"issuer": self.issuer, "client_id": self.client_id}
        return client_settings(folder, f"{self.secret}\n", **client | others)


def client_settings(folder: Path, secret: str, **table: object) -> SignInSettings:
    """Those of a client, whose secret is written into the folder."""
    file = folder / "client-secret"
    file.write_text(secret)
    usual = {"name": "Plant accounts", "client_secret_file": str(file), "roles": ROLES}
    return read_table(folder, usual | table)


def read_table(folder: Path, table: Mapping[str, object]) -> SignInSettings:
    """A table of a station.toml in a folder."""
    return SignInSettings.model_validate(dict(table), context=folder / "station.toml")


@contextmanager
def mock_provider(port: int = 0) -> Iterator[MockProvider]:
    """A provider that knows only registered clients; on a free port by default."""
    if find_spec("oidc_provider_mock") is None:
        pytest.skip("oidc-provider-mock is not installed")
    port = port or free_port()
    command = (sys.executable, "-m", "oidc_provider_mock", "--port", str(port))
    with subprocess.Popen(
        [*command, "--require-registration", "true"],
        stdout=subprocess.DEVNULL,
        stderr=subprocess.DEVNULL,
    ) as process:
        try:
            provider = MockProvider(f"http://127.0.0.1:{port}")
            _wait(provider, process)
            yield provider
        finally:
            process.kill()


def _wait(provider: MockProvider, process: "subprocess.Popen[bytes]") -> None:
    deadline = time.monotonic() + PATIENCE_S
    while True:
        try:
            httpx.get(f"{provider.issuer}/jwks").raise_for_status()
            return
        except httpx.HTTPError:
            assert process.poll() is None
            assert time.monotonic() < deadline
            time.sleep(0.1)


def answer_of(page: str, subject: str, action: str = "") -> ProviderAnswer:
    """What the provider answers when a person signs in on its page."""
    answer = httpx.post(page, data={"sub": subject, "action": action})
    assert answer.status_code == 302, answer.text
    return read_answer(answer.headers["location"])


def read_answer(address: str) -> ProviderAnswer:
    """The answer in the address to which the provider sends the browser."""
    query = dict(parse_qsl(urlsplit(address).query))
    known = {key: query[key] for key in ("state", "code", "error") if key in query}
    return ProviderAnswer(**{"state": "", **known})
