"""The pictures of a calibration: residuals on the object and on the image, the uncertainty over
the measuring volume, and where it comes from."""

from collections.abc import Sequence

import cv2
import numpy as np

from app.formats.images import read_grey
from app.formats.results.calibration import PosePart, Uncertainty
from app.formats.session.calibration_session import Pose
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
from app.report.formatting import join_units

JPEG_WIDTH, JPEG_QUALITY = 900, 72
SCALE = ("#d6e8fb", "#a9cff6", "#74b0ee", "#3f8be0", "#1f66bd", "#114688")
# Seen from so far to the side and above.
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
    """Colour and corners of what is seen of the block, what lies behind first."""
    x = [-e for e in reversed(block.edges_x_mm)] if turned else list(block.edges_x_mm)
    front, back = block.front_y_mm, block.back_y_mm
    if turned:
        front, back = -back, -front
    top, low, base = block.crest_z_mm, block.floor_z_mm, block.base_z_mm
    found: list[tuple[str, list[tuple[float, float, float]]]] = []
    # seen from the left of its front: walls that look to the left show
    for i in reversed(range(len(x) // 2)):
        left, right = x[2 * i], x[2 * i + 1]
        foot = base if i == 0 else low
        if i < len(x) // 2 - 1:
            after = x[2 * i + 2]
            floor = [(right, front, low), (after, front, low), (after, back, low)]
            found.append(("#eef0f4", [*floor, (right, back, low)]))
        crest = [(left, front, top), (right, front, top), (right, back, top), (left, back, top)]
        wall = [(left, front, foot), (left, front, top), (left, back, top), (left, back, foot)]
        found += [("#f6f7f9", crest), ("#c3cad4", wall)]
    profile = [(x[0], front, base)]
    for i in range(len(x) // 2):
        left, right = x[2 * i], x[2 * i + 1]
        if i:
            profile.append((left, front, low))
        profile += [(left, front, top), (right, front, top)]
        if i < len(x) // 2 - 1:
            profile.append((right, front, low))
    found.append(("#dde2e9", [*profile, (x[-1], front, base)]))
    sign = -1.0 if turned else 1.0
    return [(colour, np.array(corners) * [sign, sign, 1.0]) for colour, corners in found]


def object_figure(
    block: Crenellated,
    features: Sequence[str],
    points_mm: Floats,
    residuals_um: Sequence[float],
    left_out: Sequence[int],
) -> tuple[Figure, str]:
    """How far each contact (N, 3) lies off its face, as a stick along the face's normal."""
    figure = Figure(520, 205, "Residuals of the contacts on the object")
    kept = [abs(r) for i, r in enumerate(residuals_um) if i not in left_out]
    largest_mm = float(max(kept, default=0.0)) / 1e3
    factor = magnification(largest_mm, 5.0)
    for turned, x in ((False, 0.0), (True, 265.0)):
        _view(figure, (x, 4.0), block, features, points_mm, residuals_um, left_out, factor, turned)
    figure.label((2, 200), "from the front", 7.5, FAINT)
    figure.label((267, 200), "from behind", 7.5, FAINT)
    words = (
        f"Distance of each touch from its face, {factor:g} times larger: blue outside, orange "
        f"inside, crosses left out. The longest stick is {1e3 * largest_mm:.0f} µm "
        f"({largest_mm:.3f} mm)."
    )
    return figure, words


def _view(
    figure: Figure,
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
    shown = {"crest", "floor", *(("back", "right") if turned else ("front", "left"))}
    for i, (feature, point) in enumerate(zip(features, points_mm, strict=True)):
        if feature not in shown:
            continue
        normal, offset_mm = probing_face(block, feature)
        # on the face, so that the stick alone tells the distance
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


def image_figure(pose: Pose, part: PosePart, camera: Camera, measured: str) -> tuple[Figure, str]:
    """A pose's picture with the residuals of corners and stripe as arrows, magnified.

    Args:
        measured: what of the object the pose was fitted to, "Edges" or "Corners".
    """
    size = (camera.width_px, camera.height_px)
    figure = Figure(250, 250 * size[1] / size[0], f"Residuals of pose {part.number} on its picture")
    scale = figure.width / size[0]
    figure.items.append(Photo((0, 0), figure.width, figure.height, _encode_jpeg(pose)))

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
    words = (
        f"Pose {part.number}: found minus computed, {factor:g} times larger; corners yellow, at "
        f"most {worst:.2f} px; stripe red. {measured} {part.edges_rms_px:.3f} px, stripe "
        f"{part.stripe_rms_px:.3f} px rms."
        if part.stripe_points
        else f"Pose {part.number}: found minus computed, {factor:g} times larger; corners yellow, "
        f"at most {worst:.2f} px; no stripe. {measured} {part.edges_rms_px:.3f} px rms."
    )
    return figure, words


def _encode_jpeg(pose: Pose) -> bytes:
    image = read_grey(pose.ambient if pose.laser is None else pose.laser)
    ambient = read_grey(pose.ambient)
    both = np.maximum(image, ambient)
    if both.dtype != np.uint8:
        both = cv2.convertScaleAbs(both, alpha=255.0 / saturation_level(both))
    height, width = both.shape
    wide = min(width, JPEG_WIDTH)
    small = cv2.resize(both, (wide, round(height * wide / width)), interpolation=cv2.INTER_AREA)
    _, encoded = cv2.imencode(".jpg", small, [cv2.IMWRITE_JPEG_QUALITY, JPEG_QUALITY])
    return encoded.tobytes()


def _stripe_normals(uv_px: Floats) -> Floats:
    """(N, 2) unit normals of a stripe whose points follow one another, downward or rightward."""
    if len(uv_px) < 2:
        return np.tile([0.0, 1.0], (len(uv_px), 1))
    spread = uv_px.max(axis=0) - uv_px.min(axis=0)
    return np.tile([0.0, 1.0] if spread[0] >= spread[1] else [1.0, 0.0], (len(uv_px), 1))


def volume_figure(
    uncertainty: Uncertainty, camera: Camera, plane: LaserPlane
) -> tuple[Figure, str] | None:
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
    figure = Figure(520, 250, "Uncertainty over the measuring volume")
    room = (46.0, 18.0, 360.0, 195.0)
    scale = min(room[2] / (high_mm[0] - low_mm[0]), room[3] / (high_mm[1] - low_mm[1]))

    def place(points: Floats) -> list[Point]:
        on = (points - low_mm) * scale + room[:2]
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
    _axes(figure, room, low_mm, high_mm, scale)
    _legend(figure, (430.0, 30.0), low, high)
    near, far = uncertainty.depth_range_mm
    words = (
        "Standard uncertainty (k = 1) of a scanned point over the laser's plane, from "
        f"{low:.1f} µm ({low / 1e3:.4f} mm) to {high:.1f} µm ({high / 1e3:.4f} mm). Struck "
        f"through: extrapolated, nearer or further than the calibrated {near:.1f} to {far:.1f} mm "
        "from the camera."
    )
    return figure, words


def _plane_coordinates(points_mm: Floats, camera: Camera, plane: LaserPlane) -> Floats:
    """(N, 2): across, and along the camera's view, of points of the laser's plane (mm)."""
    view = camera.rotation[2]
    depth = view - float(view @ plane.normal) * plane.normal
    depth /= np.linalg.norm(depth)
    across = np.cross(depth, plane.normal)
    off = points_mm - camera.centre_mm
    return np.column_stack([off @ across, off @ view])


def _axes(
    figure: Figure,
    room: tuple[float, float, float, float],
    low_mm: Floats,
    high_mm: Floats,
    scale: float,
) -> None:
    bottom = room[1] + (high_mm[1] - low_mm[1]) * scale
    for value in _ticks(low_mm[0], high_mm[0]):
        x = room[0] + (value - low_mm[0]) * scale
        figure.line((x, bottom + 2), (x, bottom + 5), stroke=FAINT)
        figure.label((x, bottom + 14), join_units(f"{value:g}"), 7, FAINT, "middle")
    for value in _ticks(low_mm[1], high_mm[1]):
        y = room[1] + (value - low_mm[1]) * scale
        figure.line((room[0] - 5, y), (room[0] - 2, y), stroke=FAINT)
        figure.label((room[0] - 8, y + 2.5), join_units(f"{value:g}"), 7, FAINT, "end")
    middle = room[0] + (high_mm[0] - low_mm[0]) * scale / 2
    figure.label((middle, bottom + 25), "across, mm", 7.5, SOFT, "middle")
    figure.label((2, room[1] - 10), "depth, mm", 7.5, SOFT)


def _ticks(low: float, high: float) -> list[float]:
    step = next(s for s in (1, 2, 5, 10, 20, 50, 100, 200, 500) if (high - low) / s <= 8)
    return [float(v) for v in np.arange(np.ceil(low / step) * step, high + 1e-9, step)]


def _legend(figure: Figure, at: Point, low: float, high: float) -> None:
    x, y = at
    figure.label((x, y - 10), "k = 1, µm", 7.5, SOFT)
    for i, colour in enumerate(SCALE):
        figure.box((x, y + 16 * i), 16, 16, colour)
    for i in range(len(SCALE) + 1):
        value = low + (high - low) * i / len(SCALE)
        figure.label((x + 22, y + 16 * i + 2.5), f"{value:.1f}", 7, SOFT)


def _step(values: Floats) -> float:
    """The distance between neighbours of a grid."""
    sorted_values = np.unique(values)
    return float(np.median(np.diff(sorted_values))) if len(sorted_values) > 1 else 1.0


def budget_figure(
    uncertainty: Uncertainty, good_um: float | None, usable_um: float | None
) -> tuple[Figure, str]:
    """The sources as bars, the largest first, and all together against the limit."""
    rows = sorted(((r.source, r.value_um) for r in uncertainty.budget), key=lambda r: -r[1])
    rows = [*((f"{s[:1].upper()}{s[1:]}", v) for s, v in rows), ("Together", uncertainty.total_um)]
    figure = Figure(520, 17.0 * len(rows) + 20, "Error budget")
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
        figure.label((left + width + 8, y + 9), f"{value:.1f} µm", 8, INK, bold=together)
    bottom = 17.0 * len(rows) + 4
    if limit is not None:
        x = left + limit * scale
        figure.items.append(Polyline(((x, 2.0), (x, bottom)), RED, 1, dash=(3, 2)))
        figure.label((x, bottom + 10), f"good up to {limit:g} µm", 7.5, RED, "end")
    else:
        figure.line((left, bottom), (left + width, bottom), stroke=LINE, width=0.5)
    words = "What the standard uncertainty (k = 1) of a scanned point comes from."
    if usable_um is not None and good_um is not None:
        words += f" Limits: good up to {good_um:g} µm, usable up to {usable_um:g} µm."
    return figure, words
