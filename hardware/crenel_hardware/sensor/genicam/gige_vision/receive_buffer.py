"""Whether the system lets a program have a receive buffer that holds a picture of GigE Vision."""

from pathlib import Path

from crenel.messages.message import Text, message, quantity

LIMIT = Path("/proc/sys/net/core/rmem_max")
"""Linux: the largest receive buffer of a socket that a program without privileges may request."""
_ADVISED_BYTES = 33_554_432


def receive_buffer_remedy(picture_bytes: int, limit: Path = LIMIT) -> Text:
    """What to do where the limit is smaller than one picture; empty if it is not, or not known.

    Aravis requests a buffer of one picture. In a smaller one, packets are lost as soon as the
    computer is busy with something else for a few milliseconds.

    Args:
        picture_bytes: the payload of the camera.
    """
    try:
        limit_bytes = int(limit.read_text())
    except (OSError, ValueError):
        return ""
    if limit_bytes >= picture_bytes:
        return ""
    return message(
        "raise-receive-buffer",
        limit=quantity(limit_bytes / 1e3, "kB"),
        picture=quantity(picture_bytes / 1e3, "kB"),
        command=f"sudo sysctl -w net.core.rmem_max={_ADVISED_BYTES}",
    )
