"""The figures of a calibration's residuals: of the contacts on the object, and in the images."""

from collections.abc import Sequence
from typing import Literal

import cv2
import numpy as np

from crenel.formats.images import read_grey_to_show, to_8_bits
from crenel.formats.results.calibration import PosePart
from crenel.formats.session.pose_pictures import Pose
from crenel.messages.message import Text, message, quantity, rounded
from crenel.metrology.channel import Channel
from crenel.metrology.sensor.camera import Camera
from crenel.metrology.targets.crenellated_block import Crenellated, probing_face
from crenel.metrology.transforms import Floats
from crenel.report.figure import (
    FAINT,
    INSIDE,
    OUTSIDE,
    RED,
    SOFT,
    WHITE,
    Dot,
    Figure,
    Photo,
    Point,
    magnification,
)

JPEG_WIDTH, JPEG_QUALITY = 900, 72
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
        colour = OUTSIDE if residuals_um[i] >= 0 else INSIDE
        figure.line(a, b, stroke=colour, width=1.4)
        figure.items.append(Dot(a, 1.7, colour, WHITE, 0.4))


def image_figure(
    pose: Pose, channel: Channel | None, part: PosePart, camera: Camera, fitted: FitBasis
) -> tuple[Figure[Text], Text]:
    """The image of a pose with the residuals of corners and stripe as arrows, magnified."""
    size = (camera.width_px, camera.height_px)
    figure = Figure[Text](
        250, 250 * size[1] / size[0], message("residuals-pose-picture", number=part.number)
    )
    scale = figure.width / size[0]
    figure.items.append(Photo((0, 0), figure.width, figure.height, _encode_jpeg(pose, channel)))

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
            "pose-residuals-corners-without-stripe",
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


def _encode_jpeg(pose: Pose, channel: Channel | None) -> bytes:
    lit = read_grey_to_show(pose.ambient if pose.laser is None else pose.laser, channel)
    ambient = read_grey_to_show(pose.ambient, channel)
    both = to_8_bits(np.maximum(lit, ambient))
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
