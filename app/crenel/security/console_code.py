"""The code on the console: it signs a guest in, or creates the first administrator.

Separate from ``authentication``, which imports the database and the password hash: the code is
printed with the first page, before those are loaded.
"""

import secrets

LETTERS = "ABCDEFGHJKLMNPQRSTUVWXYZ23456789"
"""Without characters that look alike."""
CODE_LENGTH = 12


def new_code() -> str:
    """A code for one run of the program."""
    return "".join(secrets.choice(LETTERS) for _ in range(CODE_LENGTH))
