"""How the guide says things. Pure."""

from app.station.findings import signed


def signed_um(value: float) -> str:
    """With its sign."""
    return f"{signed(value)} µm"


def sentence(text: str) -> str:
    """With a capital letter and a full stop; empty stays empty."""
    text = text.strip().rstrip(".")
    return f"{text[0].upper()}{text[1:]}." if text else ""
