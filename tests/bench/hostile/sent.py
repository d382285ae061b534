"""Hostile addresses of devices, and answers of a provider of accounts."""

import asyncio
import gzip
import json
import random
import zlib
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path

from crenel.single_sign_on.errors import SignInError
from crenel.single_sign_on.provider import Provider
from crenel_hardware.arm.wire import Wire
from tests.bench.hostile.falling import one_of, vary
from tests.single_sign_on.mock_provider import BACK
from tests.single_sign_on.own_provider import own_provider

PATHS = ("/.well-known/openid-configuration", "/keys", "/token")
CLAIMS = ("iss", "sub", "aud", "exp", "nonce", "preferred_username", "groups")
VALUES: tuple[object, ...] = (
    *(None, "", 0, -1, 1e300, True, [], {}, [[]], "\ud800", "x" * 100_000, ["a"] * 5000),
    {"a": {"b": [1, None]}},
)
Try = Callable[[random.Random], str]


@contextmanager
def device_addresses(folder: Path) -> Iterator[Try]:
    """Addresses that are none of a device; no file is written or made."""
    others = folder.parent.parent / "others"
    files = [str(one) for one in others.iterdir()] + [str(others / "new.db"), str(folder)]
    kinds: tuple[str, ...] = (
        "spy://loop://?file=",
        "SPY://loop://?file=",
        "spy:///dev/null?raw&file=",
        "file://",
    )
    kinds += ("loop://?logging=", "hwgrep://", "alt://", "cp2110://", "socket://127.0.0.1:1/?file=")
    kinds += ("rfc2217://127.0.0.1:1?logging=", "", "/dev/../", "COM1?file=", "socket://spy://loop")

    def attempt(rng: random.Random) -> str:
        url = rng.choice(kinds) + rng.choice(files)
        if rng.random() < 0.5:
            url = vary(rng, url.encode()).decode("utf-8", "replace")
        Wire(url, 115_200).close()
        return "taken"

    yield attempt


@contextmanager
def provider_answers(folder: Path) -> Iterator[Try]:
    """What a provider says at a sign-in: compressed, nested, cut, with any claims."""
    with own_provider() as own:
        provider = Provider(own.settings(folder))

        async def sign_in() -> None:
            page, cookie = await provider.begin(BACK)
            await provider.finish(own.answer_to(page), cookie, BACK)

        def attempt(rng: random.Random) -> str:
            own.raw.clear()
            own.claims, own.header, own.payload, own.encoding = {}, {}, b"", ""
            for _ in range(rng.randint(1, 3)):
                _spoil(rng, own)
            try:
                asyncio.run(sign_in())
            except SignInError:
                return "refused"
            except KeyError:  # of this provider itself: the page that it is sent has no question
                return "refused"
            return "taken"

        yield attempt


def _spoil(rng: random.Random, own: object) -> None:
    from tests.single_sign_on.own_provider import OwnProvider

    assert isinstance(own, OwnProvider)
    deep = rng.choice((10, 60, 3000, 100_000))
    match rng.randrange(4):
        case 0:
            path = rng.choice(PATHS)
            usable = json.dumps(own.document(path)).encode()
            raw = one_of(
                rng,
                {
                    "usable": lambda: usable,
                    "nested": lambda: b'{"issuer":' * deep + b"1" + b"}" * deep,
                    "lists": lambda: b"[" * deep,
                    "zeros": lambda: bytes(1 << rng.choice((10, 20, 24))),
                },
            )
            for _ in range(rng.randint(0, 2)):
                own.encoding = rng.choice(("gzip", "deflate", "br", "gzip, gzip", "identity", "x"))
                raw = rng.choice((gzip.compress, zlib.compress, bytes))(raw)
            own.raw[path] = raw
        case 1:
            own.claims = {rng.choice(CLAIMS): rng.choice(VALUES)}
        case 2:
            own.payload = one_of(
                rng,
                {
                    "nested": lambda: b'{"a":' * deep,
                    "whole": lambda: b'{"a":' * deep + b"1" + b"}" * deep,
                    "number": lambda: b'{"exp":' + b"9" * deep + b"}",
                },
            )
        case _:
            own.header = {"alg": rng.choice(("none", "HS256", "RS256")), "kid": "x" * deep}
