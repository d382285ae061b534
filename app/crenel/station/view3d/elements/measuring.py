"""Measures picked elements, and puts figures into words; imported when the first one is picked."""

from collections.abc import Sequence
from pathlib import Path

import numpy as np

from crenel.formats.clouds.frame_readings import READINGS
from crenel.messages.message import Text, message
from crenel.metrology.transforms import Floats
from crenel.parts.elements.evaluate_element import (
    MeasuredElement,
    join_elements,
    measure_element,
    why_only_scatter,
)
from crenel.parts.elements.evaluate_errors import PickedPoints, ScanFiles, StationFiles
from crenel.parts.elements.maths_figures import ElementFigure, element_figures
from crenel.parts.elements.maths_relations import relation_figures
from crenel.parts.maths.knowledge import Knowledge
from crenel.parts.maths.shapes import Shape
from crenel.station.view3d.elements.element_views import (
    COVERAGE,
    AskedElement,
    ElementName,
    ElementRelation,
    FittedShape,
    ShapeParameter,
    UncertaintyShare,
)
from crenel.station.view3d.elements.picked_scans import PickedScan
from crenel.station.view3d.meshes import Mesh, ball, flat_mesh, tube
from crenel.station.view3d.selection import (
    Rectangle,
    SelectedPoints,
    ViewCamera,
    select_points,
)

UM_PER_MM = 1e3
MARGIN = 0.04
"""A drawn shape extends beyond the fitted points by this."""
LEAST_SHARE = 0.01
"""A share below this part of the whole is not listed."""


def measure_pick(
    camera: ViewCamera, rectangle: Rectangle, asked: AskedElement, scans: Sequence[PickedScan]
) -> tuple[MeasuredElement, SelectedPoints]:
    """Fits an element to what a browser shows in a rectangle.

    Raises:
        OperationError: there are no points, or they show no such element.
    """
    picked = select_points(camera, rectangle, [one.cloud for one in scans])
    files = {number: _files_of(one) for number, one in enumerate(scans)}
    points = PickedPoints(picked.points_mm, picked.spread_mm, picked.frame, picked.scan, files)
    viewer_mm = UM_PER_MM * np.array(camera.position_m)
    kind = None if asked == "any" else asked
    return measure_element(kind, points, picked.front, viewer_mm), picked


def _files_of(scan: PickedScan) -> ScanFiles:
    file = scan.cloud.file
    if file is None:
        return ScanFiles(None, why_unknown=message("view-scan-not-complete"))
    if scan.is_merged:
        return ScanFiles(None, why_unknown=message("view-cloud-is-merged"))
    calibrations = tuple(StationFiles(*paths) for paths in scan.calibrations)
    return ScanFiles(Path(file).with_name(READINGS), calibrations)


def describe_element(number: int, element: MeasuredElement, picked: SelectedPoints) -> FittedShape:
    """An element as the operator reads it."""
    off, left_out = np.abs(element.off_mm), element.left_out
    return FittedShape(
        id=number,
        shape=_name_of(element.shape.kind),
        second=None if element.second is None else _name_of(element.second),
        points=len(off),
        picked=picked.count,
        other_surfaces=left_out.other_surface,
        at_edges=left_out.edge,
        outliers=left_out.outlier,
        every=picked.every,
        rms_um=UM_PER_MM * float(np.sqrt(np.mean(off**2))),
        largest_um=UM_PER_MM * float(off.max()),
        form_um=UM_PER_MM * float(np.ptp(element.off_mm)),
        figures=(*_figures(element), *_direction(element.shape)),
        why_scatter=element.why_scatter,
    )


def describe_relation(
    number: int, numbers: tuple[int, int], elements: Sequence[MeasuredElement]
) -> ElementRelation:
    """The dimensions between two elements."""
    knowledge = join_elements(elements)
    why = why_only_scatter(elements)
    known = knowledge or _nothing_known(elements)
    figures = tuple(
        describe_figure(one, bool(why), knowledge is None) for one in relation_figures(known)
    )
    return ElementRelation(number, *numbers, figures, why)


def _figures(element: MeasuredElement) -> tuple[ShapeParameter, ...]:
    knowledge = element.knowledge
    known = knowledge or _nothing_known([element])
    is_scatter = element.known is None
    return tuple(
        describe_figure(one, is_scatter, knowledge is None) for one in element_figures(known)
    )


def _nothing_known(elements: Sequence[MeasuredElement]) -> Knowledge:
    count = sum(one.shape.freedom.count for one in elements)
    return Knowledge(tuple(one.shape for one in elements), {"scatter": np.zeros((count, count))})


def describe_figure(figure: ElementFigure, is_scatter: bool, is_unknown: bool) -> ShapeParameter:
    """A figure with its unit and its uncertainty, or its scatter, or neither."""
    is_angle = figure.quantity == "angle"
    scale, unit = (float(np.degrees(1.0)), "°") if is_angle else (1.0, "mm")
    u, chance = scale * figure.standard_uncertainty, figure.by_chance
    expanded = None if is_scatter or is_unknown else COVERAGE * u
    return ShapeParameter(
        label=_label(figure.name),
        value=scale * figure.value,
        unit=unit,
        decimals=3 if is_angle else 4,
        expanded=expanded,
        scatter=u if is_scatter and not is_unknown else None,
        shares=() if expanded is None else _shares(figure, COVERAGE * scale),
        by_chance=None if chance is None or expanded is None else scale * chance,
    )


def _shares(figure: ElementFigure, scale: float) -> tuple[UncertaintyShare, ...]:
    least = LEAST_SHARE * figure.standard_uncertainty
    ranked = sorted(figure.shares, key=lambda one: -one[1])
    return tuple(
        UncertaintyShare(message("uncertainty-source", source=name), scale * u)
        for name, u in ranked
        if u > least
    )


def _label(name: str) -> Text:
    if name.startswith("centre-") and name[-2:-1] == "-":
        return message("centre", axis=name[-1].upper())
    return message("element-figure", figure=name)


def _direction(shape: Shape) -> tuple[ShapeParameter, ...]:
    """The components of a normal or of an axis."""
    if shape.kind == "sphere":
        return ()
    is_plane = shape.kind == "plane"
    labels = (
        message("normal-component", axis=axis) if is_plane else message("axis-component", axis=axis)
        for axis in "XYZ"
    )
    return tuple(
        ShapeParameter(label, float(along), "", 5)
        for label, along in zip(labels, shape.direction, strict=True)
    )


def _name_of(kind: str) -> ElementName:
    assert kind in ("plane", "cylinder", "sphere", "cone")
    return kind  # type: ignore[return-value]


def element_mesh(element: MeasuredElement) -> Mesh:
    """An element as fitted to the points that are shown, slightly larger."""
    shape, x = element.as_shown, element.as_shown.local(element.used_mm)
    if shape.kind == "sphere":
        return ball(shape.origin_mm, float(shape.sizes[0]))
    if shape.kind == "plane":
        return flat_mesh(_outline(shape, x))
    low, high = _reach(x[:, 2])
    ends = shape.origin_mm + np.outer([low, high], shape.direction)
    slope = float(np.tan(shape.sizes[1])) if shape.kind == "cone" else 0.0
    radii = [max(float(shape.sizes[0]) + slope * along, 0.0) for along in (low, high)]
    return tube(ends[0], ends[1], *radii)


def _outline(shape: Shape, x: Floats) -> Floats:
    """The corners (4, 3) of a plane about points (N, 3) of its own frame."""
    flat = x[:, :2] - x[:, :2].mean(axis=0)
    a, b = np.linalg.eigh(flat.T @ flat)[1].T[::-1]
    (low_a, high_a), (low_b, high_b) = _reach(x[:, :2] @ a), _reach(x[:, :2] @ b)
    corners = [(low_a, low_b), (high_a, low_b), (high_a, high_b), (low_a, high_b)]
    flat_corners = np.array([u * a + v * b for u, v in corners])
    return np.asarray(shape.origin_mm + flat_corners @ shape.T[:3, :2].T)


def _reach(along: Floats) -> tuple[float, float]:
    low, high = (float(x) for x in np.percentile(along, [0.2, 99.8]))
    margin = MARGIN * (high - low)
    return low - margin, high + margin
