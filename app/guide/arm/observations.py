"""What an arm session took, as the identification has it."""

import numpy as np

from app.guide.arm.state import ArmState
from app.metrology.arm.identification.observations import ArmObservations, Bar, Seat, Sphere


def collect_observations(state: ArmState) -> ArmObservations:
    """What was taken so far, as the identification has it; half a bar is left out."""
    taken = [seat for seat in state.seats if seat.q_rad]
    of = {
        kind: [seat for seat in taken if seat.artefact.kind == kind]
        for kind in ("seat", "bar", "sphere")
    }
    ends = of["bar"]
    return ArmObservations(
        tuple(Seat(seat.name, np.array(seat.q_rad)) for seat in of["seat"]),
        tuple(
            Sphere(seat.name, seat.artefact.size_mm or 0.0, np.array(seat.q_rad))
            for seat in of["sphere"]
        ),
        tuple(
            Bar(
                f"{a.artefact.size_mm:g} mm",
                a.name.split(",")[0],
                a.artefact.size_mm or 0.0,
                a.artefact.standard_uncertainty_mm,
                ("A", "B"),
                (np.array(a.q_rad), np.array(b.q_rad)),
            )
            for a, b in zip(ends[::2], ends[1::2], strict=False)
        ),
    )
