"""A request that is not let pass."""

from http import HTTPStatus

from app.messages.message import Text


class AccessDeniedError(Exception):
    """A request that its sender has no right to."""

    def __init__(self, status: HTTPStatus, code: str, detail: Text, remedy: Text) -> None:
        super().__init__(detail)
        self.status, self.code, self.detail, self.remedy = status, code, detail, remedy


class TooManyAttemptsError(Exception):
    """Passwords or codes are tried too fast."""

    def __init__(self, wait_s: float) -> None:
        super().__init__(f"wait {wait_s:.0f} s")
        self.wait_s = wait_s
