"""Observations that determine an arm's geometry: seats, spheres, ball bars and coordinates that
another instrument measured, in many postures."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from crenel.messages.message import Text, message
from crenel.metrology.transforms import Floats


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
    """The name of the artefact: all positions of one bar share the error of its length."""
    position: str
    length_mm: float
    standard_uncertainty_mm: float
    ends: tuple[str, str]
    q_rad: tuple[Floats, Floats]
    """(m, n) encoder angles at each end."""


TIP = "tip"
"""The marker that is the tip itself."""
BASE = "base"
"""The frame of coordinates that are already in the arm's own frame."""


@dataclass(frozen=True)
class Coordinates:
    """One marker on the last link, as a tracker or measuring machine sees it from one place."""

    frame: str
    """The frame of the instrument, the same as long as instrument and base stand still; or
    ``BASE``."""
    marker: str
    """A reflector or ball on the last link; or ``TIP``."""
    q_rad: Floats
    """(m, n) encoder angles."""
    points_mm: Floats
    """(m, 3) in the instrument's frame."""
    standard_uncertainty_mm: Floats
    """(m,) of each coordinate, as stated; 0 if nothing is stated."""
    rotations: Floats | None = None
    """(m, 3, 3) of the marker in the instrument's frame, if its full pose was measured."""
    rotation_uncertainty_rad: Floats | None = None
    """(m,) about each axis, as stated; None without rotations."""
    offset_mm: Floats | None = None
    """(3,) of the marker in the flange frame, if it is given and not estimated."""
    lines: tuple[int, ...] = ()
    """(m,) where each point stands in its file."""

    def part(self, wanted: NDArray[np.bool_]) -> "Coordinates":
        """Only the points of a mask (m,)."""
        rotations, turning = self.rotations, self.rotation_uncertainty_rad
        return replace(
            self,
            q_rad=self.q_rad[wanted],
            points_mm=self.points_mm[wanted],
            standard_uncertainty_mm=self.standard_uncertainty_mm[wanted],
            rotations=None if rotations is None else rotations[wanted],
            rotation_uncertainty_rad=None if turning is None else turning[wanted],
            lines=tuple(line for line, own in zip(self.lines, wanted, strict=True) if own),
        )


@dataclass(frozen=True)
class Marker:
    """The prior of a marker: what is known of it without the data."""

    name: str
    offset_mm: Floats | None
    """(3,) in the flange frame, if given."""
    has_rotation: bool

    @property
    def is_estimated(self) -> bool:
        """Whether its place is an unknown of its own."""
        return self.name != TIP and self.offset_mm is None


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
    coordinates: tuple[Coordinates, ...] = ()

    @property
    def groups_count(self) -> int:
        """Seats, spheres and positions of bars."""
        return len(self.seats) + len(self.spheres) + len(self.bars)

    @property
    def coordinates_count(self) -> int:
        """Points that another instrument measured."""
        return sum(len(one.q_rad) for one in self.coordinates)

    @property
    def places_count(self) -> int:
        """Groups, and each point of another instrument."""
        return self.groups_count + self.coordinates_count

    @property
    def knows_lengths(self) -> bool:
        """Whether anything fixes the arm's scale."""
        return bool(self.bars or self.coordinates)

    def part(self, wanted: Sequence[int]) -> "ArmObservations":
        """Only the places with these numbers: seats, spheres, bars, then coordinates."""
        chosen, seats, spheres = set(wanted), len(self.seats), len(self.spheres)
        coordinates: list[Coordinates] = []
        first = self.groups_count
        for one in self.coordinates:
            own = np.array([first + i in chosen for i in range(len(one.q_rad))], dtype=bool)
            first += len(own)
            if own.any():
                coordinates.append(one.part(own))
        return ArmObservations(
            tuple(s for i, s in enumerate(self.seats) if i in chosen),
            tuple(s for i, s in enumerate(self.spheres) if i + seats in chosen),
            tuple(b for i, b in enumerate(self.bars) if i + seats + spheres in chosen),
            tuple(coordinates),
        )

    @cached_property
    def stacked(self) -> "StackedObservations":
        """All points in one array."""
        return _stack_observations(self)


@dataclass(frozen=True)
class StackedCoordinates:
    """The coordinates of all markers in one array."""

    q_rad: Floats
    """(M, n)"""
    points_mm: Floats
    """(M, 3) in the instrument's frame."""
    rotations: Floats
    """(M, 3, 3); the identity where only a point was measured."""
    has_rotation: NDArray[np.bool_]
    """(M,)"""
    standard_uncertainty_mm: Floats
    """(M,)"""
    rotation_uncertainty_rad: Floats
    """(M,)"""
    frame_of: NDArray[np.intp]
    """(M,) index of the frame of each point."""
    marker_of: NDArray[np.intp]
    """(M,) index of its marker."""
    frames: tuple[str, ...]
    markers: tuple[Marker, ...]
    lines: tuple[int, ...]


@dataclass(frozen=True)
class StackedObservations:
    """All touched points in one array, group by group, and all coordinates in another.

    Where touches and coordinates are counted together, the touches come first.
    """

    q_rad: Floats
    """(N, n)"""
    place_of: NDArray[np.intp]
    """(N,) index of the place of each touch."""
    on_sphere: NDArray[np.bool_]
    """(N,) whether a point was touched from outside, not seated."""
    places: tuple[ProbedPlace, ...]
    groups: tuple[Group, ...]
    bars: tuple[Bar, ...]
    """The bar of each group that has one, by the group's ``bar``."""
    bar_names: tuple[str, ...]
    """The artefacts; each has one error of its length."""
    coordinates: StackedCoordinates

    @property
    def touches(self) -> int:
        """N"""
        return len(self.q_rad)

    @property
    def points(self) -> int:
        """Touches and coordinates, N + M."""
        return len(self.q_rad) + len(self.coordinates.q_rad)

    @property
    def all_q_rad(self) -> Floats:
        """(N + M, n)"""
        return np.concatenate([self.q_rad, self.coordinates.q_rad])

    @cached_property
    def sphere_radii_mm(self) -> Floats:
        """(N,) calibrated radius of the sphere of each point; 0 in a seat."""
        radii = np.array([(place.diameter_mm or 0.0) / 2 for place in self.places])
        return np.asarray(radii[self.place_of])

    @cached_property
    def others(self) -> "OtherColumns":
        """The columns of the unknowns that are no parameters of the arm."""
        return OtherColumns.of(self)


@dataclass(frozen=True)
class OtherColumns:
    """Columns of the unknowns that precede the arm's parameters in the adjustment.

    First the spheres' radius excess, then the error of each bar, the twist of each frame, the
    place of each marker and its rotation. None: it is not estimated.
    """

    radius: int | None
    bars: slice
    frames: tuple[slice | None, ...]
    offsets: tuple[slice | None, ...]
    rotations: tuple[slice | None, ...]
    count: int

    @staticmethod
    def of(data: StackedObservations) -> "OtherColumns":
        """In the order above."""
        count = 0

        def take(width: int) -> slice:
            nonlocal count
            count += width
            return slice(count - width, count)

        radius = take(1).start if data.on_sphere.any() else None
        bars = take(len(data.bar_names))
        frames = [None if name == BASE else take(6) for name in data.coordinates.frames]
        markers = data.coordinates.markers
        offsets = [take(3) if marker.is_estimated else None for marker in markers]
        rotations = [take(3) if marker.has_rotation else None for marker in markers]
        return OtherColumns(radius, bars, tuple(frames), tuple(offsets), tuple(rotations), count)


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
            add(
                message("bar-end-of-position", name=bar.name, position=bar.position, end=end),
                None,
                q,
            )
            for end, q in zip(bar.ends, bar.q_rad, strict=True)
        )
        groups.append(Group(tuple(ends), number))
    joints = blocks[0].shape[1] if blocks else observations.coordinates[0].q_rad.shape[1]
    coordinates = _stack_coordinates(observations.coordinates, joints)
    return StackedObservations(
        q_rad=np.concatenate(blocks) if blocks else coordinates.q_rad[:0],
        place_of=np.repeat(np.arange(len(places)), [len(block) for block in blocks]).astype(
            np.intp
        ),
        on_sphere=np.repeat(
            np.array([place.diameter_mm is not None for place in places], dtype=bool),
            [len(block) for block in blocks],
        ),
        places=tuple(places),
        groups=tuple(groups),
        bars=observations.bars,
        bar_names=tuple(dict.fromkeys(bar.name for bar in observations.bars)),
        coordinates=coordinates,
    )


def _stack_coordinates(sets: Sequence[Coordinates], joints: int) -> StackedCoordinates:
    frames = tuple(dict.fromkeys(one.frame for one in sets))
    markers: dict[str, Marker] = {}
    for one in sets:
        turned = one.rotations is not None
        known = markers.get(one.marker)
        markers[one.marker] = Marker(
            one.marker, one.offset_mm, turned or (known is not None and known.has_rotation)
        )
    names = tuple(markers)
    counts = [len(one.q_rad) for one in sets]
    identity = np.eye(3)

    def stack(parts: list[Floats], *shape: int) -> Floats:
        return np.concatenate(parts) if parts else np.zeros((0, *shape))

    return StackedCoordinates(
        q_rad=stack([one.q_rad for one in sets], joints),
        points_mm=stack([one.points_mm for one in sets], 3),
        rotations=stack(
            [
                np.broadcast_to(identity, (count, 3, 3)) if one.rotations is None else one.rotations
                for one, count in zip(sets, counts, strict=True)
            ],
            3,
            3,
        ),
        has_rotation=np.repeat(
            np.array([one.rotations is not None for one in sets], dtype=bool), counts
        ),
        standard_uncertainty_mm=stack([one.standard_uncertainty_mm for one in sets]),
        rotation_uncertainty_rad=stack(
            [
                np.zeros(count)
                if one.rotation_uncertainty_rad is None
                else one.rotation_uncertainty_rad
                for one, count in zip(sets, counts, strict=True)
            ]
        ),
        frame_of=np.repeat([frames.index(one.frame) for one in sets], counts).astype(np.intp),
        marker_of=np.repeat([names.index(one.marker) for one in sets], counts).astype(np.intp),
        frames=frames,
        markers=tuple(markers.values()),
        lines=tuple(line for one in sets for line in one.lines),
    )
