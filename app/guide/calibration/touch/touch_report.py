"""What the touch step shows of the contact points taken so far."""

from dataclasses import dataclass

from app.findings import Finding
from app.guide.common.view import TouchedPoint
from app.messages.message import Text
from app.metrology.adjustment.planning.next_touches import TouchAdvice
from app.metrology.probing.alignment import Alignment


@dataclass(frozen=True)
class TouchReport:
    """The points, where they put the object, and the findings about them."""

    points: tuple[TouchedPoint, ...]
    alignment: Alignment | None
    """The block's place; None before it is known, and always on a board."""
    missing: Text
    """What to probe before anything can be computed; empty when nothing is missing."""
    findings: tuple[Finding, ...]
    questionable: tuple[int, ...]
    """Indices of points that should be taken away."""
    advice: TouchAdvice | None = None
    """How many more, on which face, make the object known as well as is wanted."""
    target_um: float = 0.0

    def face_rms_um(self, face: str) -> float | None:
        if self.alignment is None:
            return None
        return next((f.rms_mm * 1e3 for f in self.alignment.faces if f.face == face), None)
