"""For the container's health check: whether the station answers, over HTTP or HTTPS."""

import ssl
import sys
from http.client import HTTPConnection, HTTPException, HTTPSConnection

# it asks its own machine, by a name that no certificate has
ANY = ssl._create_unverified_context()
WAYS = (
    HTTPConnection("127.0.0.1", 8000, timeout=2),
    HTTPSConnection("127.0.0.1", 8000, timeout=2, context=ANY),
)


def status(connection: HTTPConnection) -> int | None:
    """Of the answer; none where this way of asking is not understood."""
    try:
        connection.request("GET", "/api/session")
        return connection.getresponse().status
    except (OSError, HTTPException):
        return None


answers = (answer for way in WAYS if (answer := status(way)) is not None)
sys.exit(0 if next(answers, None) == 200 else 1)
