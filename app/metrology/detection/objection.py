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
