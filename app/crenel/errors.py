"""The exceptions with which the program refuses a job."""

from crenel.messages.message import Text, join, message

STALE = "stale-view"


class OperationError(Exception):
    """A job that cannot be done correctly with the given input.

    It says what happened, why, and what to do. The command line prints it as one line and exits
    with status 1; the web answers it as RFC 9457 problem+json.

    Args:
        code: short machine-readable name, kebab-case, e.g. ``too-few-contacts``.
        what: what was refused, with the place (file, row, feature) and the value.
        why: the reason, in technical terms; may be empty.
        remedy: what to do about it; may be empty.
    """

    def __init__(self, code: str, what: Text, why: Text = "", remedy: Text = "") -> None:
        self.code = code
        self.what = what
        self.why = why
        self.remedy = remedy
        super().__init__(code)

    def __str__(self) -> str:
        return self.line

    @property
    def line(self) -> str:
        """The error as one line of English text, for logs and the console."""
        what, why, remedy = (str(text).rstrip(".") for text in (self.what, self.why, self.remedy))
        text = f"{what}: {why}" if why else what
        return f"{text}. {remedy[0].upper()}{remedy[1:]}." if remedy else f"{text}."

    @property
    def reason(self) -> Text:
        """What happened and why, as a sentence."""
        return reason_sentence(self.what, self.why)

    @property
    def text(self) -> Text:
        """The error as one text for users: what happened, why, and what to do."""
        return join([self.reason, sentence(self.remedy)], " ") if self.remedy else self.reason


class StaleViewError(OperationError):
    """A command was given on a view that is no longer the present one.

    ``view`` is the present one, for a client that shows it at once.
    """

    def __init__(self, view: object | None) -> None:
        what = message("session-went-meanwhile-nothing-done")
        super().__init__(STALE, what, remedy=message("check-current-step"))
        self.view = view


def sentence(text: Text) -> Text:
    """The text with a capital letter and a full stop; an empty text stays empty."""
    return message("sentence", text=text) if text else ""


def reason_sentence(what: Text, why: Text = "") -> Text:
    """What happened and, if known, why."""
    return message("what-and-why", what=what, why=why) if why else sentence(what)
