"""Why somebody was not signed in with an account of the provider."""

from crenel.errors import OperationError
from crenel.messages.message import Text


class SignInError(OperationError):
    """A sign-in that failed; ``what`` is one sentence for the person at the browser."""

    def __init__(self, code: str, what: Text, remedy: Text) -> None:
        super().__init__(f"sign-in-{code}", what, remedy=remedy)


class ProviderAwayError(SignInError):
    """The provider cannot be reached, or does not work as one."""
