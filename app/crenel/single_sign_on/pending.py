"""Sign-ins between their beginning and the answer of the provider.

Nothing is stored for them: state, nonce and PKCE verifier are computed from a random cookie of the
browser and a key of this process. So nobody can fill a table, or push the sign-in of another person
out of it. Only finished sign-ins are remembered, so that none is finished twice.
"""

import hashlib
import hmac
import secrets
import threading
import time
from base64 import urlsafe_b64encode
from collections import OrderedDict
from collections.abc import Callable
from dataclasses import dataclass

from crenel.messages.message import message
from crenel.single_sign_on.errors import SignInError

LASTS_S = 600
"""A person has this long to sign in at the provider."""
MOST_FINISHED = 4096
COOKIE_BYTES = 32


@dataclass(frozen=True, slots=True)
class PendingSignIn:
    """One sign-in, at one browser."""

    cookie: str
    state: str
    nonce: str
    verifier: str

    @property
    def challenge(self) -> str:
        """The PKCE challenge of the verifier, by S256.

        Source: RFC 7636, section 4.2.
        """
        return base64url(hashlib.sha256(self.verifier.encode()).digest())


@dataclass(frozen=True, slots=True)
class ProviderAnswer:
    """With what the provider sends a browser back."""

    state: str
    code: str = ""
    error: str = ""
    """In place of a code, such as ``access_denied``."""


class PendingSignIns:
    """Begins sign-ins, and finishes each once; any thread may call."""

    def __init__(self, clock: Callable[[], float] = time.monotonic) -> None:
        self._clock = clock
        self._key = secrets.token_bytes(32)
        self._finished: OrderedDict[str, float] = OrderedDict()
        """When each finished sign-in would have expired, by its cookie."""
        self._lock = threading.Lock()

    def begin(self) -> PendingSignIn:
        """A new sign-in; its cookie belongs to the browser that asked."""
        return self._derive(f"{secrets.token_urlsafe(COOKIE_BYTES)}.{int(self._clock())}")

    def finish(self, cookie: str, state: str) -> PendingSignIn:
        """The sign-in to which cookie and state belong; it cannot be finished again.

        Raises:
            SignInError: it was not begun in this browser, is too old, or was finished already.
        """
        pending = self._derive(cookie)
        if not hmac.compare_digest(pending.state.encode(), state.encode()):
            raise _begin_again_error()
        # a cookie with the right state was made here, so its time is a number
        expires_s = int(cookie.rpartition(".")[2]) + LASTS_S
        now_s = self._clock()
        with self._lock:
            while self._finished and next(iter(self._finished.values())) < now_s:
                self._finished.popitem(last=False)
            if now_s > expires_s or cookie in self._finished:
                raise _begin_again_error()
            self._finished[cookie] = expires_s
            if len(self._finished) > MOST_FINISHED:
                self._finished.popitem(last=False)
        return pending

    def _derive(self, cookie: str) -> PendingSignIn:
        state, nonce, verifier = (
            base64url(hmac.digest(self._key, f"{use} {cookie}".encode(), "sha256"))
            for use in ("state", "nonce", "verifier")
        )
        return PendingSignIn(cookie, state, nonce, verifier)


def base64url(raw: bytes) -> str:
    """Base64url without padding.

    Source: RFC 7515, section 2.
    """
    return urlsafe_b64encode(raw).rstrip(b"=").decode()


def _begin_again_error() -> SignInError:
    return SignInError(
        "begin-again", message("sign-in-not-pending"), message("sign-in-begin-again")
    )
