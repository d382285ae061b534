"""The one exception by which the program declines a job."""


class OperationError(Exception):
    """A job that cannot be done honestly with what was given.

    Carries what a person needs to go on: what happened, why, and what to do.
    The command line prints it as one line and exits with status 1; the web
    answers it as RFC 9457 problem+json.

    Args:
        code: short machine-readable name, kebab-case, e.g. ``too-few-contacts``.
        what: what was refused, with the place (file, row, feature) and the value.
        why: the reason, in the trade's words; may be empty.
        remedy: what to do about it; may be empty.
    """

    def __init__(self, code: str, what: str, why: str = "", remedy: str = "") -> None:
        self.code = code
        self.what = what
        self.why = why
        self.remedy = remedy
        super().__init__(self.line)

    @property
    def line(self) -> str:
        """The refusal as one line of text."""
        text = self.what.rstrip(".")
        if self.why:
            text += ": " + self.why.rstrip(".")
        if self.remedy:
            text += ". " + self.remedy[0].upper() + self.remedy[1:].rstrip(".")
        return text + "."
