"""What a try falls by, and how inputs are varied."""

import random
from collections.abc import Callable, Mapping

WORDS = (
    *(b"", b"0", b"-1", b"1e999", b"nan", b"5e-324", b"4294967295", b"18446744073709551615"),
    *(b"null", b"true", b"[]", b"{}", b"\x00", b"\xff\xfe", b"\xed\xa0\x80", b"\r\n", b"'", b'"'),
    *(b"../../", b"=1+1", b"%00", b"<!--", b"]]>", "\u202e".encode(), "\u00a0".encode()),
)
NUMBERS = (b"\xff" * 8, b"\x00" * 8, b"\xff\xff\xff\x7f", b"\x00\x00\x00\x80", b"\x00\x00\xf0\x7f")


class FallenError(Exception):
    """A try that ended in neither an answer nor a refusal."""

    def __init__(self, kind: str, text: str) -> None:
        super().__init__(text)
        self.kind = kind


def vary(rng: random.Random, content: bytes) -> bytes:
    """The content with one to six changes: cut, repeated, exchanged, overwritten or inserted."""
    varied = bytearray(content)
    for _ in range(rng.randint(1, 6)):
        at = rng.randrange(len(varied) + 1)
        if rng.random() < 0.5:  # in its head, which says how to read the rest
            at = min(at, rng.randrange(400))
        end = min(at + rng.choice((1, 2, 4, 8, 50, 1000)), len(varied))
        match rng.randrange(6):
            case 0:
                del varied[at:end]
            case 1:
                varied[at:at] = varied[at:end] * rng.choice((1, 2, 30))
            case 2:
                varied[at:end] = rng.randbytes(end - at)
            case 3:
                varied[at : at + 8] = rng.choice(NUMBERS)
            case 4:
                varied[at:at] = rng.choice(WORDS)
            case _ if rng.random() < 0.3:
                del varied[at:]
    return bytes(varied)


def one_of(rng: random.Random, makers: Mapping[str, Callable[[], bytes]]) -> bytes:
    """What one of them makes, as it is or varied."""
    made = makers[rng.choice(list(makers))]()
    return made if rng.random() < 0.3 else vary(rng, made)
