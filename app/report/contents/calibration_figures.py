"""The figures of a calibration: residuals on the object and in the images, the uncertainty over
the measuring volume, and its sources."""

from collections.abc import Sequence
from typing import Literal

import cv2
import numpy as np

from app.findings import capital
from app.formats.images import read_grey
from app.formats.results.calibration import PosePart, Uncertainty
from app.formats.session.calibration_session import Pose
from app.messages.message import Text, message, quantity, rounded
from app.metrology.calibration.uncertainty_budget import source_text
from app.metrology.colour import LaserColour
from app.metrology.image import saturation_level
from app.metrology.sensor.camera import Camera
from app.metrology.sensor.laser_plane import LaserPlane
from app.metrology.sensor.triangulation import sensor_points
from app.metrology.targets.crenellated_block import Crenellated, probing_face
from app.metrology.transforms import Floats
from app.report.figure import (
    BLUE,
    FAINT,
    GROUND,
    INK,
    LINE,
    ORANGE,
    RED,
    SOFT,
    Dot,
    Figure,
    Photo,
    Point,
    Polyline,
    magnification,
)
from app.report.formatting import micrometres, millimetres

JPEG_WIDTH, JPEG_QUALITY = 900, 72
SCALE = ("#d6e8fb", "#a9cff6", "#74b0ee", "#3f8be0", "#1f66bd", "#114688")
FitBasis = Literal["edges", "corners"]
"""The features of the object to which its poses were fitted."""
# Viewing direction, to the side and from above.
SIDE, ABOVE = np.radians(32.0), np.radians(38.0)


def _project_view(points_mm: Floats, turned: bool) -> Floats:
    """(N, 2) of points (N, 3) in mm, right and downward; ``turned`` looks from behind."""
    angle = SIDE + (np.pi if turned else 0.0)
    c, s = np.cos(angle), np.sin(angle)
    x = c * points_mm[:, 0] - s * points_mm[:, 1]
    away = s * points_mm[:, 0] + c * points_mm[:, 1]
    down = -(np.cos(ABOVE) * points_mm[:, 2] + np.sin(ABOVE) * away)
    return np.column_stack([x, down])


def _faces(block: Crenellated, turned: bool) -> list[tuple[str, Floats]]:
    """Colour and corners of the visible faces of the block, the rearmost first."""
    x = [-e for e in reversed(block.edges_x_mm)] if turned else list(block.edges_x_mm)
    front, back = block.front_y_mm, block.back_y_mm
    if turned:
        front, back = -back, -front
    top, low, base = block.crest_z_mm, block.floor_z_mm, block.base_z_mm
    faces: list[tuple[str, list[tuple[float, float, float]]]] = []
    # seen from the left of its front, the side faces on the left are visible
    for i in reversed(range(len(x) // 2)):
        left, right = x[2 * i], x[2 * i + 1]
        foot = base if i == 0 else low
        if i < len(x) // 2 - 1:
            after = x[2 * i + 2]
            floor = [(right, front, low), (after, front, low), (after, back, low)]
            faces.append(("#eef0f4", [*floor, (right, back, low)]))
        crest = [(left, front, top), (right, front, top), (right, back, top), (left, back, top)]
        side = [(left, front, foot), (left, front, top), (left, back, top), (left, back, foot)]
        faces += [("#f6f7f9", crest), ("#c3cad4", side)]
    profile = [(x[0], front, base)]
    for i in range(len(x) // 2):
        left, right = x[2 * i], x[2 * i + 1]
        if i:
            profile.append((left, front, low))
        profile += [(left, front, top), (right, front, top)]
        if i < len(x) // 2 - 1:
            profile.append((right, front, low))
    faces.append(("#dde2e9", [*profile, (x[-1], front, base)]))
    sign = -1.0 if turned else 1.0
    return [(colour, np.array(corners) * [sign, sign, 1.0]) for colour, corners in faces]


def object_figure(
    block: Crenellated,
    features: Sequence[str],
    points_mm: Floats,
    residuals_um: Sequence[float],
    left_out: Sequence[int],
) -> tuple[Figure[Text], Text]:
    """The distance of each contact point (N, 3) from its face, as a line along the normal of the
    face."""
    figure = Figure[Text](520, 205, message("residuals-contacts-object"))
    used_um = [abs(r) for i, r in enumerate(residuals_um) if i not in left_out]
    largest_mm = float(max(used_um, default=0.0)) / 1e3
    factor = magnification(largest_mm, 5.0)
    for turned, x in ((False, 0.0), (True, 265.0)):
        _view(figure, (x, 4.0), block, features, points_mm, residuals_um, left_out, factor, turned)
    figure.label((2, 200), message("front"), 7.5, FAINT)
    figure.label((267, 200), message("behind"), 7.5, FAINT)
    return figure, message(
        "distance-each-touch-face-times-larger",
        factor=rounded(factor),
        largest=quantity(1e3 * largest_mm, "µm"),
        largest_mm=quantity(largest_mm, "mm", 3),
    )


def _view(
    figure: Figure[Text],
    at: Point,
    block: Crenellated,
    features: Sequence[str],
    points_mm: Floats,
    residuals_um: Sequence[float],
    left_out: Sequence[int],
    factor: float,
    turned: bool,
) -> None:
    faces = _faces(block, turned)
    flat = np.vstack([_project_view(corners, turned) for _, corners in faces])
    low, high = flat.min(axis=0), flat.max(axis=0)
    scale = min(245.0 / (high[0] - low[0]), 172.0 / (high[1] - low[1]))

    def place(points: Floats) -> list[Point]:
        on = (_project_view(np.atleast_2d(points), turned) - low) * scale + at
        return [(float(u), float(v)) for u, v in on]

    for colour, corners in faces:
        figure.face(*place(corners), fill=colour, stroke=SOFT, width=0.5)
    visible = {"crest", "floor", *(("back", "right") if turned else ("front", "left"))}
    for i, (feature, point) in enumerate(zip(features, points_mm, strict=True)):
        if feature not in visible:
            continue
        normal, offset_mm = probing_face(block, feature)
        # on the face, so that the line alone is the distance
        foot = point - (float(normal @ point) - offset_mm) * normal
        tip = foot + normal * residuals_um[i] / 1e3 * factor
        (a,), (b,) = place(foot), place(tip)
        if i in left_out:
            figure.line((a[0] - 3, a[1] - 3), (a[0] + 3, a[1] + 3), stroke=RED, width=1)
            figure.line((a[0] - 3, a[1] + 3), (a[0] + 3, a[1] - 3), stroke=RED, width=1)
            continue
        colour = BLUE if residuals_um[i] >= 0 else ORANGE
        figure.line(a, b, stroke=colour, width=1.4)
        figure.items.append(Dot(a, 1.7, colour, "#ffffff", 0.4))


def image_figure(
    pose: Pose, colour: LaserColour | None, part: PosePart, camera: Camera, fitted: FitBasis
) -> tuple[Figure[Text], Text]:
    """The image of a pose with the residuals of corners and stripe as arrows, magnified."""
    size = (camera.width_px, camera.height_px)
    figure = Figure[Text](
        250, 250 * size[1] / size[0], message("residuals-pose-picture", number=part.number)
    )
    scale = figure.width / size[0]
    figure.items.append(Photo((0, 0), figure.width, figure.height, _encode_jpeg(pose, colour)))

    def at(u: float, v: float) -> Point:
        return (u + 0.5) * scale, (v + 0.5) * scale

    offs = [float(np.hypot(*off)) for off in part.corners_px.values()]
    offs += [abs(off) for _, _, off in part.stripe_off_px]
    factor = magnification(max(offs, default=0.0), 0.07 * size[0])
    stripe = [at(u, v) for u, v, _ in part.stripe_off_px]
    across = _stripe_normals(np.array([(u, v) for u, v, _ in part.stripe_off_px]).reshape(-1, 2))
    for (x, y), (nx, ny), (_, _, off) in zip(stripe, across, part.stripe_off_px, strict=True):
        end = (x + nx * off * factor * scale, y + ny * off * factor * scale)
        figure.line((x, y), end, stroke="#ff6b6f", width=0.8)
    for name, (du, dv) in part.corners_px.items():
        if name not in part.corners_at_px:
            continue
        u, v = part.corners_at_px[name]
        figure.items.append(Dot(at(u, v), 1.8, "", "#57b8ff", 0.7))
        figure.arrow(at(u, v), at(u + du * factor, v + dv * factor), "#ffe066", 0.9)
    worst = max((float(np.hypot(*off)) for off in part.corners_px.values()), default=0.0)
    magnified = rounded(factor)
    largest = quantity(worst, "px", 2)
    rms = quantity(part.edges_rms_px, "px", 3)
    if not part.stripe_points:
        return figure, message(
            "pose-found-minus-computed-times-larger-2",
            number=part.number,
            factor=magnified,
            largest=largest,
            fitted=fitted,
            rms=rms,
        )
    return figure, message(
        "pose-found-minus-computed-times-larger",
        number=part.number,
        factor=magnified,
        largest=largest,
        fitted=fitted,
        rms=rms,
        stripe_rms=quantity(part.stripe_rms_px, "px", 3),
    )


def _encode_jpeg(pose: Pose, colour: LaserColour | None) -> bytes:
    image = read_grey(pose.ambient if pose.laser is None else pose.laser, colour)
    ambient = read_grey(pose.ambient, colour)
    both = np.maximum(image, ambient)
    if both.dtype != np.uint8:
        both = cv2.convertScaleAbs(both, alpha=255.0 / saturation_level(both))
    height, width = both.shape
    wide = min(width, JPEG_WIDTH)
    small = cv2.resize(both, (wide, round(height * wide / width)), interpolation=cv2.INTER_AREA)
    _, encoded = cv2.imencode(".jpg", small, [cv2.IMWRITE_JPEG_QUALITY, JPEG_QUALITY])
    return encoded.tobytes()


def _stripe_normals(uv_px: Floats) -> Floats:
    """(N, 2) unit normals of a stripe with consecutive points, downward or rightward."""
    if len(uv_px) < 2:
        return np.tile([0.0, 1.0], (len(uv_px), 1))
    spread = uv_px.max(axis=0) - uv_px.min(axis=0)
    return np.tile([0.0, 1.0] if spread[0] >= spread[1] else [1.0, 0.0], (len(uv_px), 1))


def volume_figure(
    uncertainty: Uncertainty, camera: Camera, plane: LaserPlane
) -> tuple[Figure[Text], Text] | None:
    """The map over the laser plane, in millimetres; None if the calibration has none."""
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
            figure.line(a, c, stroke="#ffffff", width=0.5)
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
    """(N, 2): across and along the view of the camera, for points of the laser plane (mm)."""
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
    """The spacing of a grid."""
    sorted_values = np.unique(values)
    return float(np.median(np.diff(sorted_values))) if len(sorted_values) > 1 else 1.0


def budget_figure(
    uncertainty: Uncertainty, good_um: float | None, usable_um: float | None
) -> tuple[Figure[Text], Text]:
    """The sources as bars, the largest first, and the total with the limit."""
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
