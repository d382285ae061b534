"""The figures of a calibration's uncertainty: over the measuring volume, and by its sources."""

import numpy as np

from crenel.findings import capital
from crenel.formats.results.calibration import Uncertainty
from crenel.messages.message import Text, message, quantity, rounded
from crenel.metrology.calibration.uncertainty_budget import source_text
from crenel.metrology.sensor.camera import Camera
from crenel.metrology.sensor.laser_plane import LaserPlane
from crenel.metrology.sensor.triangulation import sensor_points
from crenel.metrology.transforms import Floats
from crenel.report.figure import (
    BLUE,
    FAINT,
    GROUND,
    INK,
    LINE,
    RED,
    SOFT,
    WHITE,
    Figure,
    Point,
    Polyline,
)
from crenel.report.formatting import micrometres, millimetres

SCALE = ("#d6e8fb", "#a9cff6", "#74b0ee", "#3f8be0", "#1f66bd", "#114688")


def volume_figure(
    uncertainty: Uncertainty, camera: Camera, plane: LaserPlane
) -> tuple[Figure[Text], Text] | None:
    """The map over the laser's plane, in millimetres; None where the calibration has none."""
    over = uncertainty.map
    if over is None or not over.u_um:
        return None
    uv = np.array(over.uv_px)
    du, dv = (_step(uv[:, k]) / 2 for k in range(2))
    around = [(-du, -dv), (du, -dv), (du, dv), (-du, dv)]
    corners = np.stack([sensor_points(camera, plane, uv + shift) for shift in around], axis=1)
    flat = _plane_coordinates(corners.reshape(-1, 3), camera, plane).reshape(-1, 4, 2)
    usable = np.isfinite(flat).all(axis=(1, 2))
    u_um, inside = np.array(over.u_um), np.array(over.calibrated)
    low_mm, high_mm = flat[usable].min(axis=(0, 1)), flat[usable].max(axis=(0, 1))
    figure = Figure[Text](520, 250, message("uncertainty-over-measuring-volume"))
    frame = (46.0, 18.0, 360.0, 195.0)
    scale = min(frame[2] / (high_mm[0] - low_mm[0]), frame[3] / (high_mm[1] - low_mm[1]))

    def place(points: Floats) -> list[Point]:
        on = (points - low_mm) * scale + frame[:2]
        return [(float(x), float(y)) for x, y in on]

    known = u_um[inside & usable] if (inside & usable).any() else u_um[usable]
    low, high = float(known.min()), max(float(u_um[usable].max()), 1.02 * float(known.min()))
    for cell in np.flatnonzero(usable):
        shade = min(len(SCALE) - 1, int((u_um[cell] - low) / (high - low) * len(SCALE)))
        colour = SCALE[max(0, shade)]
        figure.face(*place(flat[cell]), fill=colour, stroke=colour, width=0.3)
        if not inside[cell]:
            a, _, c, _ = place(flat[cell])
            figure.line(a, c, stroke=WHITE, width=0.5)
    _axes(figure, frame, low_mm, high_mm, scale)
    _legend(figure, (430.0, 30.0), low, high)
    near, far = uncertainty.depth_range_mm
    return figure, message(
        "standard-uncertainty-k-1-scanned-point",
        low=micrometres(low),
        low_mm=millimetres(low),
        high=micrometres(high),
        high_mm=millimetres(high),
        near=quantity(near, "", 1),
        far=quantity(far, "mm", 1),
    )


def _plane_coordinates(points_mm: Floats, camera: Camera, plane: LaserPlane) -> Floats:
    """(N, 2): across, and along the camera's view, of points of the laser's plane (mm)."""
    view = camera.rotation[2]
    depth = view - float(view @ plane.normal) * plane.normal
    depth /= np.linalg.norm(depth)
    across = np.cross(depth, plane.normal)
    off = points_mm - camera.centre_mm
    return np.column_stack([off @ across, off @ view])


def _axes(
    figure: Figure[Text],
    frame: tuple[float, float, float, float],
    low_mm: Floats,
    high_mm: Floats,
    scale: float,
) -> None:
    bottom = frame[1] + (high_mm[1] - low_mm[1]) * scale
    for value in _ticks(low_mm[0], high_mm[0]):
        x = frame[0] + (value - low_mm[0]) * scale
        figure.line((x, bottom + 2), (x, bottom + 5), stroke=FAINT)
        figure.label((x, bottom + 14), rounded(value), 7, FAINT, "middle")
    for value in _ticks(low_mm[1], high_mm[1]):
        y = frame[1] + (value - low_mm[1]) * scale
        figure.line((frame[0] - 5, y), (frame[0] - 2, y), stroke=FAINT)
        figure.label((frame[0] - 8, y + 2.5), rounded(value), 7, FAINT, "end")
    middle = frame[0] + (high_mm[0] - low_mm[0]) * scale / 2
    figure.label((middle, bottom + 25), message("across-mm"), 7.5, SOFT, "middle")
    figure.label((2, frame[1] - 10), message("depth-mm"), 7.5, SOFT)


def _ticks(low: float, high: float) -> list[float]:
    step = next(s for s in (1, 2, 5, 10, 20, 50, 100, 200, 500) if (high - low) / s <= 8)
    return [float(v) for v in np.arange(np.ceil(low / step) * step, high + 1e-9, step)]


def _legend(figure: Figure[Text], at: Point, low: float, high: float) -> None:
    x, y = at
    figure.label((x, y - 10), "k = 1, µm", 7.5, SOFT)
    for i, colour in enumerate(SCALE):
        figure.box((x, y + 16 * i), 16, 16, colour)
    for i in range(len(SCALE) + 1):
        value = low + (high - low) * i / len(SCALE)
        figure.label((x + 22, y + 16 * i + 2.5), quantity(value, "", 1), 7, SOFT)


def _step(values: Floats) -> float:
    """The distance between neighbours of a grid."""
    sorted_values = np.unique(values)
    return float(np.median(np.diff(sorted_values))) if len(sorted_values) > 1 else 1.0


def budget_figure(
    uncertainty: Uncertainty, good_um: float | None, usable_um: float | None
) -> tuple[Figure[Text], Text]:
    """The sources as bars, the largest first, and all together against the limit."""
    sources = sorted(((r.source, r.value_um) for r in uncertainty.budget), key=lambda r: -r[1])
    rows: list[tuple[Text, float]] = [
        *((capital(source_text(source)), value) for source, value in sources),
        (message("together"), uncertainty.total_um),
    ]
    figure = Figure[Text](520, 17.0 * len(rows) + 20, message("error-budget"))
    largest = max(value for _, value in rows)
    limit = good_um if good_um is not None and good_um < 2.5 * largest else None
    left, width = 120.0, 320.0
    scale = width / max(largest, limit or 0.0, 1e-9)
    for i, (source, value) in enumerate(rows):
        y = 17.0 * i + 4
        together = i == len(rows) - 1
        figure.label((left - 8, y + 9), source, 8, INK if together else SOFT, "end", together)
        figure.box((left, y + 1), width, 11, GROUND)
        figure.box((left, y + 1), max(value * scale, 0.5), 11, INK if together else BLUE)
        figure.label((left + width + 8, y + 9), micrometres(value), 8, INK, bold=together)
    bottom = 17.0 * len(rows) + 4
    if limit is not None:
        x = left + limit * scale
        figure.items.append(Polyline(((x, 2.0), (x, bottom)), RED, 1, dash=(3, 2)))
        mark = message("good-up-m", limit=rounded(limit, "µm"))
        figure.label((x, bottom + 10), mark, 7.5, RED, "end")
    else:
        figure.line((left, bottom), (left + width, bottom), stroke=LINE, width=0.5)
    if usable_um is None or good_um is None:
        return figure, message("what-standard-uncertainty-k-1-scanned")
    good, usable = rounded(good_um, "µm"), rounded(usable_um, "µm")
    return figure, message("error-budget-with-limits", good=good, usable=usable)
