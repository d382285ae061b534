"""Sign-in by name and password, by the console's code, and by a kiosk link.

It also has the errors for refused requests.
"""

import threading
from hmac import compare_digest
from http import HTTPStatus

from crenel.errors import OperationError
from crenel.messages.message import Text, message
from crenel.security.login_throttle import Throttle, address_key
from crenel.store.access_tokens import AccessTokenStore
from crenel.store.accounts import Account, AccountStore, Role, plain_name
from crenel.store.login_sessions import LoginSessionStore, Principal


class AccessDeniedError(Exception):
    """A request for which its sender has no permission."""

    def __init__(self, status: HTTPStatus, code: str, detail: Text, remedy: Text) -> None:
        super().__init__(detail)
        self.status, self.code, self.detail, self.remedy = status, code, detail, remedy


class TooManyAttemptsError(Exception):
    """Passwords or codes are tried too fast."""

    def __init__(self, wait_s: float) -> None:
        super().__init__(f"wait {wait_s:.0f} s")
        self.wait_s = wait_s


class Authenticator:
    """Decides who may sign in; any thread may call, one attempt is checked at a time.

    On the first start, while there is no administrator, a code on the console creates the first
    one, once. A demonstration has a guest instead, who can sign in with its code as long as it
    runs.
    """

    def __init__(
        self,
        accounts: AccountStore,
        sign_ins: LoginSessionStore,
        api_tokens: AccessTokenStore,
        guest: str | None,
        code: str,
    ) -> None:
        self._accounts, self._sign_ins, self._guest = accounts, sign_ins, guest
        self._api_tokens = api_tokens
        self._throttle = Throttle()
        self._lock = threading.Lock()
        self._code = code
        if guest is not None:
            accounts.admit_guest(guest)

    @property
    def first_start(self) -> bool:
        """Whether the code creates the first administrator."""
        return self._guest is None and not self._accounts.has_admin()

    @property
    def by_code(self) -> bool:
        """Whether the code signs a guest in."""
        return self._guest is not None and self._accounts.get(self._guest) is not None

    @property
    def code(self) -> str | None:
        """The text for the console; None if no code is valid."""
        return self._code if self.by_code or self.first_start else None

    def sign_in(self, name: str, password: str, address: str, browser: str = "") -> Account | None:
        """The account; None if name and password do not match.

        Args:
            browser: the token of a known browser. Its attempts count separately, so that guesses
                elsewhere lock nobody out.

        Raises:
            TooManyTries: for this name, from this address, or in this browser.
        """
        plain = plain_name(name).lower()
        with self._lock:
            if self._sign_ins.is_known_browser(browser, plain):
                keys: tuple[str, ...] = (f"browser {browser}",)
            else:
                keys = (f"name {plain}", address_key(address))
            self._check_throttle(*keys)
            account = self._accounts.authenticate(name, password)
            self._note(account is not None, *keys)
        return account

    def guest_by_code(self, code: str, address: str) -> str | None:
        """The account of the guest, by the console's code; None for a wrong one."""
        with self._lock:
            return self._guest if self.by_code and self._matches(code, address) else None

    def make_admin(self, code: str, name: str, password: str, address: str) -> Account | None:
        """The first administrator, by the console's code; None for a wrong one.

        Raises:
            OperationError: there already is one, or name or password is unsuitable.
        """
        with self._lock:
            if not self.first_start:
                raise OperationError(
                    "not-first-start",
                    message("station-has-administrator-already"),
                    remedy=message("sign-ask-administrator-account"),
                )
            if not self._matches(code, address):
                return None
            return self._accounts.add(name, Role.admin, password)

    def kiosk_by_link(self, token: str, address: str) -> Principal | None:
        """The kiosk of a link."""
        key = address_key(address)
        with self._lock:
            self._check_throttle(key)
            visitor = self._sign_ins.principal(token)
            found = visitor if visitor is not None and visitor.kiosk else None
            self._note(found is not None, key)
        return found

    def check_metrics_token(self, token: str, address: str) -> bool:
        """Whether a program may read the metrics with this token."""
        key = f"metrics {address_key(address)}"
        with self._lock:
            self._check_throttle(key)
            good = self._api_tokens.find(token) is not None
            self._note(good, key)
        return good

    def check_provider_attempts(self, address: str) -> None:
        """Raises ``TooManyAttemptsError`` after many failed sign-ins with the provider's accounts
        from this address."""
        with self._lock:
            self._check_throttle(f"provider {address_key(address)}")

    def note_provider_attempt(self, good: bool, address: str) -> None:
        """Notes the end of a sign-in with an account of the provider."""
        with self._lock:
            self._note(good, f"provider {address_key(address)}")

    def _matches(self, code: str, address: str) -> bool:
        key = address_key(address)
        self._check_throttle(key)
        plain = "".join(code.upper().replace("-", "").split())
        good = compare_digest(plain.encode(), self._code.encode())
        self._note(good, key)
        return good

    def _check_throttle(self, *keys: str) -> None:
        wait_s = self._throttle.wait_s(*keys)
        if wait_s > 0:
            raise TooManyAttemptsError(wait_s)

    def _note(self, good: bool, *keys: str) -> None:
        if good:
            self._throttle.note_success(*keys)
        else:
            self._throttle.note_failure(*keys)
