"""A small provider that says what no proper one says: forged, expired and foreign tokens."""

import base64
import hashlib
import hmac
import json
import secrets
import ssl
import threading
import time
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass, field
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path
from typing import Any
from urllib.parse import parse_qs, urlencode, urlsplit

from joserfc import jws
from joserfc.jwk import RSAKey

from crenel.single_sign_on.pending import ProviderAnswer, base64url
from crenel.single_sign_on.settings import SignInSettings
from tests.single_sign_on.mock_provider import client_settings, read_answer

CLIENT, SECRET = "station-2", "kept secret by both"


def rsa_key(kid: str) -> RSAKey:
    return RSAKey.generate_key(2048, {"kid": kid, "use": "sig"})


FIRST_KEY = rsa_key("first")


@dataclass
class OwnProvider:
    """What it says; tests change it."""

    issuer: str
    key: RSAKey = field(default_factory=lambda: FIRST_KEY)
    """It signs with this one."""
    published: list[dict[str, Any]] = field(default_factory=list)
    """In place of its own public key, if not empty."""
    claims: dict[str, object] = field(default_factory=dict)
    """In place of the right ones; None leaves a claim out."""
    payload: bytes = b""
    """In place of all claims, if not empty."""
    header: dict[str, str] = field(default_factory=dict)
    metadata: dict[str, object] = field(default_factory=dict)
    user_info: dict[str, object] = field(default_factory=dict)
    raw: dict[str, bytes] = field(default_factory=dict)
    """Answers by path, in place of the right ones."""
    encoding: str = ""
    """How it says that its answers are compressed."""
    asked: list[str] = field(default_factory=list)
    """Paths, in the order of the requests."""
    token_answer: tuple[int, dict[str, object]] | None = None
    codes: dict[str, dict[str, str]] = field(default_factory=dict)
    """The request of each code that was not used yet."""

    def settings(self, folder: Path, **others: object) -> SignInSettings:
        client = {"issuer": self.issuer, "client_id": CLIENT}
        return client_settings(folder, SECRET, **client | others)

    def answer_to(self, page: str) -> ProviderAnswer:
        """The answer after somebody signed in on its page."""
        return read_answer(self.authorise(page))

    def authorise(self, page: str) -> str:
        """The address to which it sends the browser."""
        query = {key: values[0] for key, values in parse_qs(urlsplit(page).query).items()}
        assert query["response_type"] == "code"
        assert query["code_challenge_method"] == "S256"
        code = secrets.token_urlsafe(16)
        self.codes[code] = query
        answer = urlencode({"code": code, "state": query["state"]})
        return f"{query['redirect_uri']}?{answer}"

    def document(self, path: str) -> dict[str, object]:
        """What it answers to a GET."""
        if path == "/.well-known/openid-configuration":
            return {
                "issuer": self.issuer,
                "authorization_endpoint": f"{self.issuer}/authorize",
                "token_endpoint": f"{self.issuer}/token",
                "jwks_uri": f"{self.issuer}/keys",
                **self.metadata,
            }
        if path == "/keys":
            return {"keys": self.published or [self.key.as_dict(private=False)]}
        return self.user_info

    def tokens(self, form: Mapping[str, str], authorization: str) -> tuple[int, dict[str, object]]:
        """What it answers to a code."""
        if self.token_answer is not None:
            return self.token_answer
        expected = base64.b64encode(f"{CLIENT}:{SECRET.replace(' ', '%20')}".encode()).decode()
        if authorization != f"Basic {expected}":
            return 401, {"error": "invalid_client"}
        asked = self.codes.pop(form["code"], None)
        digest = hashlib.sha256(form["code_verifier"].encode()).digest()
        if asked is None or (base64url(digest), form["redirect_uri"]) != (
            asked["code_challenge"],
            asked["redirect_uri"],
        ):
            return 400, {"error": "invalid_grant"}
        return 200, {
            "access_token": "an access token",
            "token_type": "Bearer",
            "id_token": self.id_token(asked["nonce"]),
        }

    def id_token(self, nonce: str) -> str:
        """The ID token, as it is now to be."""
        now = int(time.time())
        claims: dict[str, object] = {
            "iss": self.issuer,
            "sub": "1234",
            "aud": CLIENT,
            "iat": now,
            "exp": now + 300,
            "nonce": nonce,
            "preferred_username": "anna",
            "groups": ["sensor-operators"],
            **self.claims,
        }
        claims = {key: value for key, value in claims.items() if value is not None}
        header = {"alg": "RS256", "kid": "first", **self.header}
        if header["alg"] == "RS256":
            payload = self.payload or json.dumps(claims).encode()  # any text, as its escape
            return jws.serialize_compact(header, payload, self.key, ["RS256"])
        parts = [base64url(json.dumps(part).encode()) for part in (header, claims)]
        signature = b""
        if header["alg"].startswith("HS"):  # with the public key as if it were a shared secret
            public = self.key.as_pem(private=False)
            digest = f"sha{header['alg'][2:]}"
            signature = hmac.digest(public, ".".join(parts).encode(), digest)
        return ".".join((*parts, base64url(signature)))


@contextmanager
def own_provider(tls: ssl.SSLContext | None = None) -> Iterator[OwnProvider]:
    """It runs until the end of the block."""
    server = ThreadingHTTPServer(("127.0.0.1", 0), BaseHTTPRequestHandler)
    if tls is not None:
        server.socket = tls.wrap_socket(server.socket, server_side=True)
    scheme = "http" if tls is None else "https"
    provider = OwnProvider(f"{scheme}://127.0.0.1:{server.server_address[1]}")
    server.RequestHandlerClass = type("Handler", (_Handler,), {"provider": provider})
    server.handle_error = lambda *_: None  # type: ignore[method-assign]  # broken off on purpose
    thread = threading.Thread(target=server.serve_forever, kwargs={"poll_interval": 0.05})
    thread.start()
    try:
        yield provider
    finally:
        server.shutdown()
        thread.join()
        server.server_close()


class _Handler(BaseHTTPRequestHandler):
    provider: OwnProvider

    def do_GET(self) -> None:
        path = urlsplit(self.path).path
        self.provider.asked.append(path)
        if path in self.provider.raw:
            self._send(200, self.provider.raw[path])
        else:
            self._send(200, json.dumps(self.provider.document(path)).encode())

    def do_POST(self) -> None:
        self.provider.asked.append(self.path)
        body = self.rfile.read(int(self.headers["Content-Length"])).decode()
        form = {key: values[0] for key, values in parse_qs(body).items()}
        status, document = self.provider.tokens(form, self.headers.get("Authorization", ""))
        self._send(status, json.dumps(document).encode())

    def _send(self, status: int, body: bytes) -> None:
        self.send_response(status)
        self.send_header("Content-Type", "application/json")
        if self.provider.encoding:
            self.send_header("Content-Encoding", self.provider.encoding)
        self.send_header("Content-Length", str(len(body)))
        self.end_headers()
        self.wfile.write(body)

    def log_message(self, *_: object) -> None:
        """Nobody reads it."""
