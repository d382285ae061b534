"""Observations that determine an arm's geometry: seats, spheres and ball bars in many postures."""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from app.messages.message import Text, message
from app.metrology.transforms import Floats


@dataclass(frozen=True)
class Seat:
    """A cone or ball seat that holds the tip while the arm moves (single-point articulation)."""

    name: str
    q_rad: Floats
    """(m, n) encoder angles."""


@dataclass(frozen=True)
class Sphere:
    """A calibrated sphere at one place, touched from outside."""

    name: str
    diameter_mm: float
    q_rad: Floats
    """(m, n) encoder angles."""


@dataclass(frozen=True)
class Bar:
    """A ball bar in one position: two seats at a calibrated distance."""

    name: str
    """Of the artefact: all positions of one bar share the error of its length."""
    position: str
    length_mm: float
    standard_uncertainty_mm: float
    ends: tuple[str, str]
    q_rad: tuple[Floats, Floats]
    """(m, n) encoder angles at each end."""


@dataclass(frozen=True)
class ProbedPlace:
    """One unknown centre and the points measured at it."""

    label: Text
    diameter_mm: float | None
    """None if the tip was in a seat."""
    rows: slice
    """Indices of its points among all points."""


@dataclass(frozen=True)
class Group:
    """Places that are solved together: a seat, a sphere, or the two ends of a bar."""

    places: tuple[int, ...]
    bar: int | None = None


@dataclass(frozen=True)
class ArmObservations:
    """All measured places; any kind may be missing."""

    seats: tuple[Seat, ...] = ()
    spheres: tuple[Sphere, ...] = ()
    bars: tuple[Bar, ...] = ()

    @property
    def groups_count(self) -> int:
        return len(self.seats) + len(self.spheres) + len(self.bars)

    def part(self, wanted: Sequence[int]) -> "ArmObservations":
        """Only the groups with these numbers, counted over seats, spheres, then bars."""
        chosen, seats, spheres = set(wanted), len(self.seats), len(self.spheres)
        return ArmObservations(
            tuple(s for i, s in enumerate(self.seats) if i in chosen),
            tuple(s for i, s in enumerate(self.spheres) if i + seats in chosen),
            tuple(b for i, b in enumerate(self.bars) if i + seats + spheres in chosen),
        )

    @cached_property
    def stacked(self) -> "StackedObservations":
        """All points in one array."""
        return _stack_observations(self)


@dataclass(frozen=True)
class StackedObservations:
    """The points of all places in one array, group by group."""

    q_rad: Floats
    """(N, n)"""
    place_of: NDArray[np.intp]
    """(N,) index of the place of each point."""
    on_sphere: NDArray[np.bool_]
    """(N,) whether a point was touched from outside, not seated."""
    places: tuple[ProbedPlace, ...]
    groups: tuple[Group, ...]
    bars: tuple[Bar, ...]
    """The bar of each group that has one, by the group's ``bar``."""
    bar_names: tuple[str, ...]
    """The artefacts; each has one error of its length."""

    @cached_property
    def sphere_radii_mm(self) -> Floats:
        """(N,) calibrated radius of the sphere of each point; 0 in a seat."""
        radii = np.array([(place.diameter_mm or 0.0) / 2 for place in self.places])
        return np.asarray(radii[self.place_of])


def _stack_observations(observations: ArmObservations) -> StackedObservations:
    blocks: list[Floats] = []
    places: list[ProbedPlace] = []
    groups: list[Group] = []
    count = 0

    def add(label: Text, diameter_mm: float | None, q_rad: Floats) -> int:
        nonlocal count
        places.append(ProbedPlace(label, diameter_mm, slice(count, count + len(q_rad))))
        blocks.append(q_rad)
        count += len(q_rad)
        return len(places) - 1

    for seat in observations.seats:
        groups.append(Group((add(message("seat-named", name=seat.name), None, seat.q_rad),)))
    for sphere in observations.spheres:
        groups.append(
            Group(
                (add(message("sphere-named", name=sphere.name), sphere.diameter_mm, sphere.q_rad),)
            )
        )
    for number, bar in enumerate(observations.bars):
        ends = (
            add(message("bar-end-2", name=bar.name, position=bar.position, end=end), None, q)
            for end, q in zip(bar.ends, bar.q_rad, strict=True)
        )
        groups.append(Group(tuple(ends), number))
    return StackedObservations(
        q_rad=np.concatenate(blocks),
        place_of=np.repeat(np.arange(len(places)), [len(block) for block in blocks]),
        on_sphere=np.repeat(
            [place.diameter_mm is not None for place in places], [len(b) for b in blocks]
        ),
        places=tuple(places),
        groups=tuple(groups),
        bars=observations.bars,
        bar_names=tuple(dict.fromkeys(bar.name for bar in observations.bars)),
    )
