"""A sign-in with a provider: what must be right in its answer, and what is said if it is not."""

import asyncio
import socket
import ssl
import time
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import pytest
import trustme
from joserfc.jwk import ECKey, OctKey

from app.single_sign_on import connection
from app.single_sign_on.connection import LARGEST_ANSWER
from app.single_sign_on.errors import SignInError
from app.single_sign_on.id_token import SKEW_S
from app.single_sign_on.pending import ProviderAnswer
from app.single_sign_on.person import ProviderPerson
from app.single_sign_on.provider import AT_ONCE, Provider
from tests.refusals import refused
from tests.single_sign_on.mock_provider import BACK
from tests.single_sign_on.own_provider import OwnProvider, own_provider, rsa_key

pytestmark = pytest.mark.device


@pytest.fixture
def own() -> Iterator[OwnProvider]:
    with own_provider() as running:
        yield running


@pytest.fixture
def provider(own: OwnProvider, tmp_path: Path) -> Provider:
    return Provider(own.settings(tmp_path))


def sign_in(provider: Provider, own: OwnProvider) -> ProviderPerson:
    """A whole sign-in."""
    page, cookie = asyncio.run(provider.begin(BACK))
    return asyncio.run(provider.finish(own.answer_to(page), cookie, BACK))


def failure_of(provider: Provider, own: OwnProvider) -> str:
    """Why a sign-in fails."""
    with pytest.raises(SignInError) as failed:
        sign_in(provider, own)
    return failed.value.code


def test_a_person_signs_in(own: OwnProvider, provider: Provider) -> None:
    assert sign_in(provider, own) == ProviderPerson("1234", "anna", "operator")
    assert provider.trouble == ""


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
        ({"exp": None}, "clock"),
        ({"exp": "soon"}, "clock"),
        ({"preferred_username": None}, "no-name"),
        ({"preferred_username": ["anna"]}, "no-name"),
    ],
)
def test_a_token_for_something_else_is_refused(
    own: OwnProvider, provider: Provider, claims: dict[str, object], code: str
) -> None:
    own.claims = claims
    assert failure_of(provider, own) == f"sign-in-{code}"


@pytest.mark.parametrize(
    "claims",
    [
        {"aud": ["station-2", "station-3"], "azp": "station-2"},
        {"at_hash": "FPlcM-1UXiivOYozpUrp7Q"},
    ],
    ids=["several audiences", "at_hash"],
)
def test_a_token_with_what_may_differ_is_taken(
    own: OwnProvider, provider: Provider, claims: dict[str, object]
) -> None:
    own.claims = claims
    assert sign_in(provider, own).name == "anna"


@pytest.mark.parametrize(
    ("claim", "off_s"), [("exp", -SKEW_S - 5), ("iat", SKEW_S + 60), ("nbf", SKEW_S + 60)]
)
def test_clocks_that_differ_too_much_are_named(
    own: OwnProvider, provider: Provider, claim: str, off_s: int
) -> None:
    own.claims = {claim: int(time.time()) + off_s}
    assert failure_of(provider, own) == "sign-in-clock"


def test_clocks_may_differ_a_little(own: OwnProvider, provider: Provider) -> None:
    own.claims = {"exp": int(time.time()) - SKEW_S // 4}
    assert sign_in(provider, own).name == "anna"


def test_a_forged_signature_is_refused(own: OwnProvider, provider: Provider) -> None:
    own.published = [rsa_key("first").as_dict(private=False)]
    assert failure_of(provider, own) == "sign-in-signature"


@pytest.mark.parametrize("algorithm", ["none", "HS256", "HS512"])
def test_a_token_that_anyone_could_make_is_refused(
    own: OwnProvider, tmp_path: Path, algorithm: str
) -> None:
    own.header = {"alg": algorithm}
    assert failure_of(Provider(own.settings(tmp_path)), own) == "sign-in-signature"
    own.published = [OctKey.import_key("a public secret", {"kid": "first"}).as_dict(private=True)]
    assert failure_of(Provider(own.settings(tmp_path)), own) == "sign-in-signature"


@pytest.mark.parametrize("token", ["", "a.b.c", "x" * 300_000, "..", "e30.e30.e30"])
def test_what_is_no_token_is_refused(own: OwnProvider, provider: Provider, token: str) -> None:
    own.token_answer = 200, {"access_token": "one", "id_token": token}
    assert failure_of(provider, own) == "sign-in-signature"


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
def test_addresses_that_are_none_are_refused(
    own: OwnProvider, provider: Provider, metadata: dict[str, object]
) -> None:
    own.metadata = metadata
    assert failure_of(provider, own).startswith("sign-in-provider-")


def test_an_error_that_is_no_text_is_refused(own: OwnProvider, provider: Provider) -> None:
    own.metadata = {"token_endpoint_auth_methods_supported": 7}
    own.token_answer = 400, {"error": "\ud800"}
    assert failure_of(provider, own) == "sign-in-provider-unusable"


def test_new_keys_of_the_provider_are_fetched(own: OwnProvider, provider: Provider) -> None:
    sign_in(provider, own)
    sign_in(provider, own)
    assert own.asked.count("/keys") == 1
    own.key, own.header = rsa_key("second"), {"kid": "second"}
    assert sign_in(provider, own).name == "anna"
    own.key = rsa_key("second")  # the same name
    assert sign_in(provider, own).name == "anna"
    assert own.asked.count("/keys") == 3


def test_keys_that_are_no_use_are_left_out(own: OwnProvider, provider: Provider) -> None:
    encryption = {**rsa_key("first").as_dict(private=False), "use": "enc"}
    other = ECKey.generate_key("P-256", {"kid": "other"}).as_dict(private=False)
    strange = [{"kty": "lattice", "kid": "first"}, {"kty": "RSA", "kid": "first"}, "none", {}]
    own.published = [encryption, *strange, other, own.key.as_dict(private=False)]  # type: ignore[list-item]
    assert sign_in(provider, own).name == "anna"


def test_a_sign_in_is_finished_once_and_in_its_own_browser(
    own: OwnProvider, provider: Provider, tmp_path: Path
) -> None:
    page, cookie = asyncio.run(provider.begin(BACK))
    _, other = asyncio.run(provider.begin(BACK))
    answer = own.answer_to(page)
    for wrong in (other, "", "x", f"{cookie}0"):
        with refused("sign-in-begin-again"):
            asyncio.run(provider.finish(answer, wrong, BACK))
    with refused("sign-in-begin-again"):
        asyncio.run(provider.finish(replace(answer, state="x"), cookie, BACK))
    assert asyncio.run(provider.finish(answer, cookie, BACK)).name == "anna"
    for one in (provider, Provider(own.settings(tmp_path))):
        with refused("sign-in-begin-again"):
            asyncio.run(one.finish(answer, cookie, BACK))


def test_a_code_of_another_sign_in_is_refused_by_its_verifier(
    own: OwnProvider, provider: Provider
) -> None:
    page, cookie = asyncio.run(provider.begin(BACK))
    stolen = own.answer_to(asyncio.run(provider.begin(BACK))[0])
    answer = replace(own.answer_to(page), code=stolen.code)
    with refused("sign-in-code"):
        asyncio.run(provider.finish(answer, cookie, BACK))


@pytest.mark.parametrize(
    ("answer", "code"),
    [
        ((401, {"error": "invalid_client"}), "secret"),
        ((400, {"error": "unauthorized_client"}), "secret"),
        ((400, {"error": "invalid_grant"}), "code"),
        ((400, {"error": {"any": "thing"}}), "refused"),
        ((500, {}), "provider-unusable"),
        ((200, {"access_token": "one"}), "provider-unusable"),
    ],
)
def test_what_the_provider_says_to_a_code_is_reported(
    own: OwnProvider, provider: Provider, answer: tuple[int, dict[str, object]], code: str
) -> None:
    own.token_answer = answer
    assert failure_of(provider, own) == f"sign-in-{code}"


@pytest.mark.parametrize(
    ("error", "code"),
    [("access_denied", "cancelled"), ("server_error", "refused"), ("", "refused")],
)
def test_what_the_provider_says_in_place_of_a_code_is_reported(
    own: OwnProvider, provider: Provider, error: str, code: str
) -> None:
    page, cookie = asyncio.run(provider.begin(BACK))
    answer = ProviderAnswer(own.answer_to(page).state, error=error)
    with refused(f"sign-in-{code}"):
        asyncio.run(provider.finish(answer, cookie, BACK))


def test_groups_come_from_where_the_provider_has_them(
    own: OwnProvider, provider: Provider, tmp_path: Path
) -> None:
    own.claims = {"groups": None, "realm_access": {"roles": ["sensor-admins", "sensor-viewers"]}}
    nested = Provider(own.settings(tmp_path, groups_claim="realm_access.roles"))
    assert sign_in(nested, own).role == "admin"
    own.metadata = {"userinfo_endpoint": f"{own.issuer}/user"}
    own.user_info = {"sub": "1234", "groups": "sensor-viewers"}
    assert sign_in(provider, own).role == "viewer"
    own.user_info = {"sub": "another", "groups": "sensor-admins"}
    assert sign_in(provider, own).role is None


def test_only_allowed_groups_sign_in(own: OwnProvider, tmp_path: Path) -> None:
    provider = Provider(own.settings(tmp_path, allowed_groups=["plant-1"]))
    assert sign_in(provider, own).role is None
    own.claims = {"groups": ["plant-1", "sensor-viewers"]}
    assert sign_in(provider, own).role == "viewer"
    own.claims = {"groups": ["plant-1"]}
    assert sign_in(provider, own).role is None


def test_a_provider_that_is_away_differs_from_one_that_is_none(
    own: OwnProvider, provider: Provider
) -> None:
    own.metadata = {"issuer": "https://another.example.org"}
    assert failure_of(provider, own) == "sign-in-other-issuer"
    assert provider.trouble
    own.metadata = {"token_endpoint": "http://sso.example.org/token"}
    assert failure_of(provider, own) == "sign-in-provider-unusable"
    own.metadata = {}
    for raw in (b"<html>", b"[]", b" " * (LARGEST_ANSWER + 1), b"[" * 100_000):
        own.raw["/.well-known/openid-configuration"] = raw
        assert failure_of(provider, own) == "sign-in-provider-unusable"
    own.raw.clear()
    assert provider.check() == ""
    assert provider.trouble == ""


def test_a_provider_that_nobody_reaches_or_that_is_silent(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
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


def test_more_sign_ins_at_once_than_the_provider_gets_are_asked_to_wait(
    own: OwnProvider, provider: Provider
) -> None:
    async def crowd() -> list[object]:
        return await asyncio.gather(
            *(provider.begin(BACK) for _ in range(2 * AT_ONCE)), return_exceptions=True
        )

    answers = asyncio.run(crowd())
    busy = [one for one in answers if isinstance(one, SignInError)]
    assert [one.code for one in busy] == ["sign-in-busy"] * AT_ONCE
    assert sign_in(provider, own).name == "anna"


def test_the_certificate_of_the_provider_is_checked(tmp_path: Path) -> None:
    authority = trustme.CA()
    tls = ssl.SSLContext(ssl.PROTOCOL_TLS_SERVER)
    authority.issue_cert("127.0.0.1").configure_cert(tls)
    authority.cert_pem.write_to_path(tmp_path / "ca.pem")
    with own_provider(tls) as own:
        assert failure_of(Provider(own.settings(tmp_path)), own) == "sign-in-certificate"
        trusting = Provider(own.settings(tmp_path, ca_file="ca.pem"))
        assert sign_in(trusting, own).name == "anna"
    expired = ssl.SSLContext(ssl.PROTOCOL_TLS_SERVER)
    authority.issue_cert("another.example.org").configure_cert(expired)
    with own_provider(expired) as own:
        trusting = Provider(own.settings(tmp_path, ca_file="ca.pem"))
        assert failure_of(trusting, own) == "sign-in-certificate"
