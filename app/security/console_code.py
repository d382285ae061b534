"""The code that the console shows: whoever has it enters, or makes the first administrator.

Apart from ``authentication``, which loads the database and the password hash: the code is
printed with the first page, before those.
"""

import secrets

LETTERS = "ABCDEFGHJKLMNPQRSTUVWXYZ23456789"
"""Without those that are taken for others."""
CODE_LENGTH = 12


def new_code() -> str:
    """A code for one run of the program."""
    return "".join(secrets.choice(LETTERS) for _ in range(CODE_LENGTH))
