"""How the station is reached over the network."""

from typing import Literal

Network = Literal["here", "encrypted", "proxied", "open"]
"""From where the station is reached: from this machine alone, or from others in some way."""
