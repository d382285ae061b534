"""A sign-in with a provider: what must be right in its answer, and what is said if it is not."""

import asyncio
import gzip
import json
import socket
import ssl
import time
import zlib
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import pytest
import trustme
from joserfc.jwk import ECKey, OctKey

from crenel.formats.json_document import DEEPEST
from crenel.single_sign_on import connection
from crenel.single_sign_on.connection import LARGEST_ANSWER, MOST_PARTS
from crenel.single_sign_on.errors import SignInError
from crenel.single_sign_on.id_token import SKEW_S
from crenel.single_sign_on.pending import ProviderAnswer
from crenel.single_sign_on.person import ProviderPerson
from crenel.single_sign_on.provider import AT_ONCE, Provider
from tests.refusals import refused
from tests.single_sign_on.mock_provider import BACK
from tests.single_sign_on.own_provider import OwnProvider, own_provider, rsa_key

pytestmark = pytest.mark.device


class Client(Provider):
    """A station at a provider that says what a test wants."""

    def __init__(self, own: OwnProvider, folder: Path, **others: object) -> None:
        super().__init__(own.settings(folder, **others))
        self.own = own

    def sign_in(self) -> ProviderPerson:
        page, cookie = asyncio.run(self.begin(BACK))
        return asyncio.run(self.finish(self.own.answer_to(page), cookie, BACK))

    def failure(self) -> str:
        """The code of a sign-in that fails."""
        with pytest.raises(SignInError) as failed:
            self.sign_in()
        return failed.value.code


@pytest.fixture
def client(tmp_path: Path) -> Iterator[Client]:
    with own_provider() as own:
        yield Client(own, tmp_path)


def test_a_person_signs_in(client: Client) -> None:
    assert client.sign_in() == ProviderPerson("1234", "anna", "operator")
    assert client.trouble == ""


@pytest.mark.parametrize(
    ("claims", "code"),
    [
        ({"nonce": "of another sign-in"}, "foreign"),
        ({"nonce": None}, "foreign"),
        ({"aud": "station-3"}, "foreign"),
        ({"aud": ["station-3"]}, "foreign"),
        ({"aud": None}, "foreign"),
        ({"aud": ["station-2", "station-3"]}, "foreign"),
        ({"azp": "station-3"}, "foreign"),
        ({"iss": "https://another.example.org"}, "foreign"),
        ({"iss": None}, "foreign"),
        ({"sub": None}, "foreign"),
        ({"sub": ""}, "foreign"),
        ({"sub": 7}, "foreign"),
        ({"at_hash": "of another token"}, "foreign"),
        ({"at_hash": 7}, "foreign"),
        ({"sub": "\ud800"}, "foreign"),
        ({"groups": ["\ud800"]}, "foreign"),
        ({"groups": json.loads("[" * DEEPEST + "]" * DEEPEST)}, "foreign"),
        ({"exp": None}, "clock"),
        ({"exp": "soon"}, "clock"),
        ({"preferred_username": None}, "no-name"),
        ({"preferred_username": ["anna"]}, "no-name"),
    ],
)
def test_a_foreign_token_is_refused(client: Client, claims: dict[str, object], code: str) -> None:
    client.own.claims = claims
    assert client.failure() == f"sign-in-{code}"


def test_a_token_that_is_nested_without_end_is_refused(client: Client) -> None:
    client.own.payload = b'{"a":' * 50_000
    assert client.failure() == "sign-in-signature"


@pytest.mark.parametrize(
    "claims",
    [
        {"aud": ["station-2", "station-3"], "azp": "station-2"},
        {"at_hash": "FPlcM-1UXiivOYozpUrp7Q"},
    ],
    ids=["several audiences", "at_hash"],
)
def test_a_token_with_what_may_differ_is_taken(client: Client, claims: dict[str, object]) -> None:
    client.own.claims = claims
    assert client.sign_in().name == "anna"


@pytest.mark.parametrize(
    ("claim", "off_s"), [("exp", -SKEW_S - 5), ("iat", SKEW_S + 60), ("nbf", SKEW_S + 60)]
)
def test_clocks_that_differ_too_much_are_named(client: Client, claim: str, off_s: int) -> None:
    client.own.claims = {claim: int(time.time()) + off_s}
    assert client.failure() == "sign-in-clock"


def test_clocks_may_differ_a_little(client: Client) -> None:
    client.own.claims = {"exp": int(time.time()) - SKEW_S // 4}
    assert client.sign_in().name == "anna"


def test_a_forged_signature_is_refused(client: Client) -> None:
    client.own.published = [rsa_key("first").as_dict(private=False)]
    assert client.failure() == "sign-in-signature"


@pytest.mark.parametrize("algorithm", ["none", "HS256", "HS512"])
def test_a_token_of_anyone_is_refused(client: Client, tmp_path: Path, algorithm: str) -> None:
    client.own.header = {"alg": algorithm}
    assert Client(client.own, tmp_path).failure() == "sign-in-signature"
    public = OctKey.import_key("a public secret", {"kid": "first"})
    client.own.published = [public.as_dict(private=True)]
    assert Client(client.own, tmp_path).failure() == "sign-in-signature"


@pytest.mark.parametrize(
    "metadata",
    [
        {"token_endpoint": "http://127.0.0.1:99999/"},
        {"token_endpoint": "https://xn--a/"},
        {"jwks_uri": "http://127.0.0.1:1/\ud800"},
        {"authorization_endpoint": "https://["},
    ],
    ids=ascii,
)
def test_addresses_that_are_none_are_refused(client: Client, metadata: dict[str, object]) -> None:
    client.own.metadata = metadata
    assert client.failure().startswith("sign-in-provider-")


def test_an_error_that_is_no_text_is_refused(client: Client) -> None:
    client.own.metadata = {"token_endpoint_auth_methods_supported": 7}
    client.own.token_answer = 400, {"error": "\ud800"}
    assert client.failure() == "sign-in-provider-unusable"


def test_new_keys_of_the_provider_are_fetched(client: Client) -> None:
    client.sign_in()
    client.sign_in()
    assert client.own.asked.count("/keys") == 1
    client.own.key, client.own.header = rsa_key("second"), {"kid": "second"}
    assert client.sign_in().name == "anna"
    client.own.key = rsa_key("second")  # the same name
    assert client.sign_in().name == "anna"
    assert client.own.asked.count("/keys") == 3


def test_keys_that_are_no_use_are_left_out(client: Client) -> None:
    encryption = {**rsa_key("first").as_dict(private=False), "use": "enc"}
    other = ECKey.generate_key("P-256", {"kid": "other"}).as_dict(private=False)
    strange = [{"kty": "lattice", "kid": "first"}, {"kty": "RSA", "kid": "first"}, "none", {}]
    client.own.published = [encryption, *strange, other, client.own.key.as_dict(private=False)]  # type: ignore[list-item]
    assert client.sign_in().name == "anna"


def test_a_sign_in_is_finished_once_and_in_its_own_browser(client: Client, tmp_path: Path) -> None:
    page, cookie = asyncio.run(client.begin(BACK))
    _, other = asyncio.run(client.begin(BACK))
    answer = client.own.answer_to(page)
    for wrong in (other, "", "x", f"{cookie}0"):
        with refused("sign-in-begin-again"):
            asyncio.run(client.finish(answer, wrong, BACK))
    with refused("sign-in-begin-again"):
        asyncio.run(client.finish(replace(answer, state="x"), cookie, BACK))
    assert asyncio.run(client.finish(answer, cookie, BACK)).name == "anna"
    for one in (client, Client(client.own, tmp_path)):
        with refused("sign-in-begin-again"):
            asyncio.run(one.finish(answer, cookie, BACK))


def test_a_code_of_another_sign_in_is_refused_by_its_verifier(client: Client) -> None:
    page, cookie = asyncio.run(client.begin(BACK))
    stolen = client.own.answer_to(asyncio.run(client.begin(BACK))[0])
    answer = replace(client.own.answer_to(page), code=stolen.code)
    with refused("sign-in-code"):
        asyncio.run(client.finish(answer, cookie, BACK))


@pytest.mark.parametrize(
    ("answer", "code"),
    [
        ((401, {"error": "invalid_client"}), "secret"),
        ((400, {"error": "unauthorized_client"}), "secret"),
        ((400, {"error": "invalid_grant"}), "code"),
        ((400, {"error": {"any": "thing"}}), "refused"),
        ((500, {}), "provider-unusable"),
        ((200, {"access_token": "one"}), "provider-unusable"),
        *(
            ((200, {"access_token": "one", "id_token": no_token}), "signature")
            for no_token in ("", "a.b.c", "x" * 300_000, "..", "e30.e30.e30")
        ),
    ],
)
def test_what_the_provider_says_to_a_code_is_reported(
    client: Client, answer: tuple[int, dict[str, object]], code: str
) -> None:
    client.own.token_answer = answer
    assert client.failure() == f"sign-in-{code}"


@pytest.mark.parametrize(
    ("error", "code"),
    [("access_denied", "cancelled"), ("server_error", "refused"), ("", "refused")],
)
def test_what_comes_in_place_of_a_code_is_reported(client: Client, error: str, code: str) -> None:
    page, cookie = asyncio.run(client.begin(BACK))
    answer = ProviderAnswer(client.own.answer_to(page).state, error=error)
    with refused(f"sign-in-{code}"):
        asyncio.run(client.finish(answer, cookie, BACK))


def test_groups_come_from_where_the_provider_has_them(client: Client, tmp_path: Path) -> None:
    roles = ["sensor-admins", "sensor-viewers"]
    client.own.claims = {"groups": None, "realm_access": {"roles": roles}}
    nested = Client(client.own, tmp_path, groups_claim="realm_access.roles")
    assert nested.sign_in().role == "admin"
    client.own.metadata = {"userinfo_endpoint": f"{client.own.issuer}/user"}
    client.own.user_info = {"sub": "1234", "groups": "sensor-viewers"}
    assert client.sign_in().role == "viewer"
    client.own.user_info = {"sub": "another", "groups": "sensor-admins"}
    assert client.sign_in().role is None


def test_only_allowed_groups_sign_in(client: Client, tmp_path: Path) -> None:
    provider = Client(client.own, tmp_path, allowed_groups=["plant-1"])
    assert provider.sign_in().role is None
    client.own.claims = {"groups": ["plant-1", "sensor-viewers"]}
    assert provider.sign_in().role == "viewer"
    client.own.claims = {"groups": ["plant-1"]}
    assert provider.sign_in().role is None


def test_a_provider_that_is_away_differs_from_one_that_is_none(client: Client) -> None:
    client.own.metadata = {"issuer": "https://another.example.org"}
    assert client.failure() == "sign-in-other-issuer"
    assert client.trouble
    client.own.metadata = {"token_endpoint": "http://sso.example.org/token"}
    assert client.failure() == "sign-in-provider-unusable"
    client.own.metadata = {}
    nested = b'{"issuer":' * DEEPEST + b"{}" + b"}" * DEEPEST
    many = b'{"a":[' + b"[]," * MOST_PARTS + b"[]]}"
    for raw in (b"<html>", b"[]", b" " * (LARGEST_ANSWER + 1), b"[" * 100_000, nested, many):
        client.own.raw["/.well-known/openid-configuration"] = raw
        assert client.failure() == "sign-in-provider-unusable"
    client.own.raw.clear()
    assert client.check() == ""
    assert client.trouble == ""


def test_compressed_answers_are_unpacked_up_to_the_size_of_an_answer(client: Client) -> None:
    path = "/.well-known/openid-configuration"
    usable, bomb = json.dumps(client.own.document(path)).encode(), gzip.compress(bytes(1 << 28))
    for encoding, raw, trouble in (
        ("gzip", gzip.compress(usable), ""),
        ("deflate", zlib.compress(usable), ""),
        ("gzip", bomb, "unusable"),
        ("gzip", gzip.compress(bomb), "unusable"),
        ("gzip", gzip.compress(usable)[:-1], "unusable"),
        ("gzip, gzip", gzip.compress(gzip.compress(usable)), "unusable"),
        ("br", usable, "unusable"),
    ):
        client.own.raw[path], client.own.encoding = raw, encoding
        client.own.asked.clear()
        assert bool(client.check()) == bool(trouble), (encoding, raw[:80])
        assert client.own.asked == [path]


def test_an_unreached_or_silent_provider(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    with own_provider() as own:
        provider = Provider(own.settings(tmp_path))
    with refused("sign-in-provider-away"):
        asyncio.run(provider.begin(BACK))
    assert str(provider.check()) == str(provider.trouble) == "Plant accounts cannot be reached"
    monkeypatch.setattr(connection, "ANSWER_WITHIN_S", 0.2)
    with socket.socket() as silent:
        silent.bind(("127.0.0.1", 0))
        silent.listen()
        issuer = f"http://127.0.0.1:{silent.getsockname()[1]}"
        provider = Provider(own.settings(tmp_path, issuer=issuer))
        with refused("sign-in-provider-away"):
            asyncio.run(provider.begin(BACK))


def test_more_sign_ins_at_once_than_the_provider_gets_are_asked_to_wait(client: Client) -> None:
    async def crowd() -> list[object]:
        return await asyncio.gather(
            *(client.begin(BACK) for _ in range(2 * AT_ONCE)), return_exceptions=True
        )

    answers = asyncio.run(crowd())
    busy = [one for one in answers if isinstance(one, SignInError)]
    assert [one.code for one in busy] == ["sign-in-busy"] * AT_ONCE
    assert client.sign_in().name == "anna"


def test_the_certificate_of_the_provider_is_checked(tmp_path: Path) -> None:
    authority = trustme.CA()
    tls = ssl.SSLContext(ssl.PROTOCOL_TLS_SERVER)
    authority.issue_cert("127.0.0.1").configure_cert(tls)
    authority.cert_pem.write_to_path(tmp_path / "ca.pem")
    with own_provider(tls) as own:
        assert Client(own, tmp_path).failure() == "sign-in-certificate"
        trusting = Client(own, tmp_path, ca_file="ca.pem")
        assert trusting.sign_in().name == "anna"
    expired = ssl.SSLContext(ssl.PROTOCOL_TLS_SERVER)
    authority.issue_cert("another.example.org").configure_cert(expired)
    with own_provider(expired) as own:
        trusting = Client(own, tmp_path, ca_file="ca.pem")
        assert trusting.failure() == "sign-in-certificate"
