"""A provider of accounts: sign-ins with it, by the authorization code flow with PKCE.

Source: OpenID Connect Core 1.0, section 3.1; OpenID Connect Discovery 1.0; RFC 7636 (PKCE);
OpenID Connect RP-Initiated Logout 1.0.
"""

import asyncio
import logging
import time
from collections.abc import AsyncIterator, Callable, Mapping
from contextlib import asynccontextmanager
from typing import Any
from urllib.parse import quote, urlencode

import httpx
from joserfc.jwk import KeySet

from crenel.messages.message import Text, message
from crenel.single_sign_on.connection import ProviderConnection
from crenel.single_sign_on.errors import ProviderAwayError, SignInError
from crenel.single_sign_on.id_token import (
    UnknownKeyError,
    read_id_token,
    read_keys,
    signature_error,
)
from crenel.single_sign_on.pending import PendingSignIn, PendingSignIns, ProviderAnswer
from crenel.single_sign_on.person import ProviderPerson, find_claim, read_person
from crenel.single_sign_on.settings import SignInSettings, is_encrypted_or_local

log = logging.getLogger(__name__)
DISCOVERY = "/.well-known/openid-configuration"
METADATA_S, KEYS_S, ACCEPTED_S = 10.0, 3600.0, 600.0
"""How long the provider's configuration, its keys, and that it accepts an address are known."""
DONE_WITHIN_S = 8.0
"""All requests of a step together."""
AT_ONCE = 4
"""Sign-ins that ask the provider at the same time."""
MOST_ACCEPTED = 64
REFUSED = 400
NEEDED = ("authorization_endpoint", "token_endpoint", "jwks_uri")


class Provider:
    """One provider; its methods run on one event loop, except ``check``.

    Args:
        settings: checked ones.
    """

    def __init__(
        self, settings: SignInSettings, clock: Callable[[], float] = time.monotonic
    ) -> None:
        self.settings = settings
        self.trouble: Text = ""
        """Why the provider could not be used the last time; empty if it could."""
        self._clock = clock
        self._connection = ProviderConnection(settings.name, settings.ca_file)
        self._pending = PendingSignIns()
        self._metadata: tuple[float, dict[str, Any]] | None = None
        self._keys: tuple[float, KeySet] | None = None
        self._accepted: dict[str, float] = {}
        """When the provider accepted a redirect address."""
        self._asking = 0

    @property
    def name(self) -> str:
        return self.settings.name

    async def begin(self, back: str) -> tuple[str, str]:
        """Begins a sign-in.

        Args:
            back: to where the provider sends the browser, its redirect URI.

        Returns:
            The address of the provider's page, and the cookie for the browser.

        Raises:
            SignInError: the provider cannot be used, or does not accept client and address.
        """
        async with self._place():
            metadata = await self._read_metadata()
            pending = self._pending.begin()
            await self._check_accepted(metadata, back)
            return self._page(metadata, pending, back), pending.cookie

    async def finish(self, answer: ProviderAnswer, cookie: str, back: str) -> ProviderPerson:
        """The person whom the provider signed in.

        Args:
            cookie, back: those of ``begin``.

        Raises:
            SignInError: the sign-in was not begun in this browser, or something is not as it must
                be.
        """
        async with self._place():
            pending = self._pending.finish(cookie, answer.state)
            if answer.error or not answer.code:
                raise _answer_error(answer.error, self.name)
            metadata = await self._read_metadata()
            id_token, access_token = await self._exchange(metadata, answer.code, pending, back)
            claims = await self._read_claims(metadata, id_token, access_token, pending.nonce)
            claims = await self._add_user_info(metadata, claims, access_token)
        return read_person(claims, self.settings)

    async def sign_out_address(self, back: str) -> str:
        """The page on which the provider ends its own session; empty if there is none.

        Args:
            back: to where it sends the browser afterwards.
        """
        if self.settings.sign_out != "provider":
            return ""
        try:
            metadata = await self._read_metadata()
        except ProviderAwayError:
            return ""
        page = metadata.get("end_session_endpoint")
        if not isinstance(page, str) or not is_encrypted_or_local(page):
            return ""
        query = {"client_id": self.settings.client_id, "post_logout_redirect_uri": back}
        return _with_query(page, query)

    def check(self) -> Text:
        """Why the provider cannot be used now; empty if it can. For a thread of its own."""
        try:
            asyncio.run(self._fetch_metadata())
        except ProviderAwayError as error:
            return error.what
        return ""

    @asynccontextmanager
    async def _place(self) -> AsyncIterator[None]:
        """For what asks the provider; a browser does not wait longer for its answer.

        Raises:
            SignInError: too many sign-ins ask the provider already, or it takes too long.
        """
        if self._asking >= AT_ONCE:
            raise SignInError(
                "busy", message("sign-in-too-many", name=self.name), message("try-again")
            )
        self._asking += 1
        try:
            async with asyncio.timeout(DONE_WITHIN_S):
                yield
        except TimeoutError as error:
            raise self._connection.away_error(error) from error
        finally:
            self._asking -= 1

    async def _read_metadata(self) -> dict[str, Any]:
        known = self._metadata
        if known is not None and self._clock() - known[0] < METADATA_S:
            return known[1]
        metadata = await self._fetch_metadata()
        self._metadata = self._clock(), metadata
        return metadata

    async def _fetch_metadata(self) -> dict[str, Any]:
        try:
            address = self.settings.issuer.rstrip("/") + DISCOVERY
            metadata = await self._connection.get_document(address)
            self._check_metadata(metadata)
        except ProviderAwayError as error:
            self.trouble = error.what
            raise
        self.trouble = ""
        return metadata

    def _check_metadata(self, metadata: Mapping[str, Any]) -> None:
        if metadata.get("issuer") != self.settings.issuer:
            log.warning("%s has the issuer %r", self.name, metadata.get("issuer"))
            raise ProviderAwayError(
                "other-issuer",
                message("sign-in-other-issuer", name=self.name),
                message("sign-in-check-issuer"),
            )
        if not all(is_encrypted_or_local(str(metadata.get(key))) for key in NEEDED):
            log.warning("%s does not name all of %s with https", self.name, ", ".join(NEEDED))
            raise self._connection.unusable_error()

    def _page(self, metadata: Mapping[str, Any], pending: PendingSignIn, back: str) -> str:
        query = {
            "response_type": "code",
            "client_id": self.settings.client_id,
            "redirect_uri": back,
            "scope": " ".join(self.settings.scopes),
            "state": pending.state,
            "nonce": pending.nonce,
            "code_challenge": pending.challenge,
            "code_challenge_method": "S256",
        }
        return _with_query(metadata["authorization_endpoint"], query)

    async def _check_accepted(self, metadata: Mapping[str, Any], back: str) -> None:
        """Whether the provider knows client and address.

        If it does not, it shows its own error page and sends nobody back: the station would never
        know. So the station asks for that page first, with a sign-in that is never finished.
        """
        if self._clock() - self._accepted.get(back, float("-inf")) < ACCEPTED_S:
            return
        page = self._page(metadata, self._pending.begin(), back)
        if await self._connection.get_status(page) == REFUSED:
            raise SignInError(
                "not-registered",
                message("sign-in-not-registered", name=self.name),
                message("sign-in-register", client=self.settings.client_id, address=back),
            )
        if len(self._accepted) >= MOST_ACCEPTED:
            self._accepted.clear()
        self._accepted[back] = self._clock()

    async def _exchange(
        self, metadata: Mapping[str, Any], code: str, pending: PendingSignIn, back: str
    ) -> tuple[str, str]:
        """ID token and access token for a code."""
        form = {
            "grant_type": "authorization_code",
            "code": code,
            "redirect_uri": back,
            "code_verifier": pending.verifier,
        }
        auth: tuple[str, str] | None = None
        client_id, secret = self.settings.client_id, self.settings.client_secret()
        methods = metadata.get("token_endpoint_auth_methods_supported")
        if secret is None:
            form["client_id"] = client_id
        elif not isinstance(methods, list) or "client_secret_basic" in methods:
            # RFC 6749, section 2.3.1: both are encoded like a form
            auth = quote(client_id, safe=""), quote(secret, safe="")
        else:
            form |= {"client_id": client_id, "client_secret": secret}
        status, tokens = await self._connection.post_form(metadata["token_endpoint"], form, auth)
        if status != httpx.codes.OK:
            raise _token_error(tokens.get("error"), self.name)
        id_token, access_token = tokens.get("id_token"), tokens.get("access_token")
        if not isinstance(id_token, str) or not isinstance(access_token, str):
            raise self._connection.unusable_error()
        return id_token, access_token

    async def _read_claims(
        self, metadata: Mapping[str, Any], id_token: str, access_token: str, nonce: str
    ) -> dict[str, Any]:
        """The claims of the ID token; after a change of its keys, the provider is asked again."""
        issuer, client = self.settings.issuer, self.settings.client_id
        for fresh in (False, True):
            keys = await self._read_keys(metadata, fresh)
            try:
                return await asyncio.to_thread(
                    read_id_token, id_token, keys, issuer, client, nonce, access_token, self.name
                )
            except UnknownKeyError as error:
                log.info("an ID token of %s has another key: %s", self.name, error.__cause__)
        raise signature_error(self.name)

    async def _read_keys(self, metadata: Mapping[str, Any], fresh: bool) -> KeySet:
        known = self._keys
        if known is not None and not fresh and self._clock() - known[0] < KEYS_S:
            return known[1]
        document = await self._connection.get_document(metadata["jwks_uri"])
        keys = await asyncio.to_thread(read_keys, document)
        self._keys = self._clock(), keys
        return keys

    async def _add_user_info(
        self, metadata: Mapping[str, Any], claims: dict[str, Any], access_token: str
    ) -> dict[str, Any]:
        """The claims, with those that the provider states only when asked for them.

        Source: OpenID Connect Core 1.0, section 5.3.
        """
        wanted = (self.settings.name_claim, self.settings.groups_claim)
        address = metadata.get("userinfo_endpoint")
        if all(find_claim(claims, one) is not None for one in wanted) or address is None:
            return claims
        more = await self._connection.get_document(str(address), access_token)
        return {**more, **claims} if more.get("sub") == claims["sub"] else claims


def _with_query(page: str, query: Mapping[str, str]) -> str:
    return f"{page}{'&' if '?' in page else '?'}{urlencode(query)}"


def _answer_error(error: str, name: str) -> SignInError:
    """The error with which the provider sent the browser back."""
    if error == "access_denied":
        return SignInError(
            "cancelled", message("sign-in-cancelled", name=name), message("sign-in-begin-again")
        )
    return SignInError(
        "refused",
        message("sign-in-refused", name=name, error=error or "no_code"),
        message("sign-in-tell-administrator"),
    )


def _token_error(error: object, name: str) -> SignInError:
    """The error with which the provider refused a code."""
    log.warning("%s refuses a code: %s", name, error)
    if error in ("invalid_client", "unauthorized_client"):
        return SignInError(
            "secret", message("sign-in-wrong-secret", name=name), message("sign-in-correct-secret")
        )
    if error == "invalid_grant":
        return SignInError(
            "code", message("sign-in-code-refused", name=name), message("sign-in-begin-again")
        )
    return SignInError(
        "refused",
        message("sign-in-refused", name=name, error=str(error)[:40]),
        message("sign-in-tell-administrator"),
    )
