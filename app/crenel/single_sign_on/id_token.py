"""Checks the ID token, in which the provider states who signed in.

Source: OpenID Connect Core 1.0, section 3.1.3.7.
"""

import hashlib
import hmac
import logging
from collections.abc import Iterator
from typing import Any

from joserfc import jwt
from joserfc.errors import (
    BadSignatureError,
    ClaimError,
    ExpiredTokenError,
    InvalidKeyIdError,
    JoseError,
)
from joserfc.jwk import JWKRegistry, Key, KeySet
from joserfc.jws import JWSRegistry

from crenel.formats.json_document import is_deep, is_valid_unicode
from crenel.messages.message import message
from crenel.single_sign_on.errors import SignInError
from crenel.single_sign_on.pending import base64url

log = logging.getLogger(__name__)
SKEW_S = 120
"""By how much the clocks of provider and server may differ."""
ALGORITHMS = (
    "RS256", "RS384", "RS512", "PS256", "PS384", "PS512", "ES256", "ES384", "ES512", "Ed25519",
    "EdDSA",
)  # fmt: skip
"""Signatures by a key that only the provider has; neither none, nor a shared secret."""
TIMES = ("exp", "iat", "nbf")
LONGEST_SUBJECT = 255


class _Registry(JWSRegistry):
    """Accepts also headers that it does not know, and certificates in them."""

    max_header_length = 16_384


REGISTRY = _Registry(algorithms=ALGORITHMS, strict_check_header=False)


class UnknownKeyError(Exception):
    """The token is not signed by any of these keys; the provider may have newer ones."""


def read_keys(document: dict[str, Any]) -> KeySet:
    """The signing keys of a JWK set; others, and those of unknown kinds, are left out."""
    return KeySet(list(_signing_keys(document.get("keys"))))


def _signing_keys(given: object) -> Iterator[Key]:
    for one in given if isinstance(given, list) else ():
        if not isinstance(one, dict) or one.get("use", "sig") != "sig" or one.get("kty") == "oct":
            continue
        try:
            yield JWKRegistry.import_key(one)
        except (JoseError, ValueError, TypeError, KeyError) as error:
            log.info("a key of the provider is left out: %s", error)


def read_id_token(
    token: str, keys: KeySet, issuer: str, client_id: str, nonce: str, access_token: str, name: str
) -> dict[str, Any]:
    """The claims of an ID token, after every check.

    Args:
        nonce: of the sign-in for which it was made.
        access_token: the one that came with it.
        name: the provider's, in messages.

    Raises:
        UnknownKeyError: it is not signed by one of the keys.
        SignInError: it is not signed at all, expired, or was made for something else.
    """
    try:
        read = jwt.decode(token, keys, registry=REGISTRY)
        claims = read.claims
        jwt.JWTClaimsRegistry(
            leeway=SKEW_S,
            iss={"essential": True, "value": issuer},
            sub={"essential": True},
            aud={"essential": True, "value": client_id},
            exp={"essential": True},
            iat={"essential": True},
            nonce={"essential": True, "value": nonce},
        ).validate(claims)
    except (BadSignatureError, InvalidKeyIdError) as error:
        raise UnknownKeyError from error
    except ClaimError as error:
        log.warning("an ID token of %s is refused: %s", name, error)
        if isinstance(error, ExpiredTokenError) or error.claim in TIMES:
            raise _clock_error(name) from error
        raise _foreign_error(name) from error
    except (JoseError, ValueError, TypeError, RecursionError) as error:
        log.warning("an ID token of %s is refused: %s", name, error)
        raise signature_error(name) from error
    if is_deep(claims) or not is_valid_unicode(claims):
        log.warning("an ID token of %s is refused: nested deeply, or half of a character", name)
        raise _foreign_error(name)
    _check_parties(claims, client_id, name)
    _check_access_token(claims.get("at_hash"), access_token, str(read.header.get("alg")), name)
    return claims


def _check_parties(claims: dict[str, Any], client_id: str, name: str) -> None:
    """Raises ``SignInError`` for a token that another client requested, or without a subject."""
    several = isinstance(claims["aud"], list) and len(claims["aud"]) > 1
    party = claims.get("azp", None if several else client_id)
    if party != client_id or not 0 < len(claims["sub"]) <= LONGEST_SUBJECT:
        log.warning("an ID token of %s is refused: azp or sub", name)
        raise _foreign_error(name)


def _check_access_token(expected: object, access_token: str, algorithm: str, name: str) -> None:
    """Raises ``SignInError`` if the access token is not the one of the ID token.

    Source: OpenID Connect Core 1.0, section 3.1.3.8.
    """
    if expected is None or not algorithm[-3:].isdecimal():
        return
    digest = hashlib.new(f"sha{algorithm[-3:]}", access_token.encode()).digest()
    actual = base64url(digest[: len(digest) // 2])
    if not isinstance(expected, str) or not hmac.compare_digest(expected.encode(), actual.encode()):
        log.warning("an ID token of %s is refused: at_hash", name)
        raise _foreign_error(name)


def signature_error(name: str) -> SignInError:
    """The answer is not signed by the provider."""
    return SignInError(
        "signature",
        message("sign-in-not-signed-by-provider", name=name),
        message("sign-in-tell-administrator"),
    )


def _clock_error(name: str) -> SignInError:
    return SignInError(
        "clock", message("sign-in-token-expired", name=name), message("sign-in-check-clocks")
    )


def _foreign_error(name: str) -> SignInError:
    return SignInError(
        "foreign", message("sign-in-token-foreign", name=name), message("sign-in-begin-again")
    )
