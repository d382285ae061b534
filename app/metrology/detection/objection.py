"""What speaks against a placing of the block, and where in the picture."""

from dataclasses import dataclass


@dataclass(frozen=True)
class Objection:
    """Why the picture does not bear a placing out.

    ``definite``: it shows other measures, rather than too little; ``edges``: rows in the
    wireframe of those that disagree.
    """

    text: str
    definite: bool = False
    edges: tuple[int, ...] = ()


def elsewhere(edge: str, off_mm: float, edges: tuple[int, ...]) -> Objection:
    """The objection that a size differs: an edge of it, how far it lies off, all its edges."""
    return Objection(
        f"its edge {edge} seems to lie {off_mm:.2f} mm from where the certificate puts it",
        True,
        edges,
    )
