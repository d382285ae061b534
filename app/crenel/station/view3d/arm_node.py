"""The arm in the 3D view: links, probe, sensor and laser, moved by its own kinematics."""

from typing import Protocol

import numpy as np
import viser

from crenel.metrology.arm.kinematics import AnyArm, Arm, Tip
from crenel.metrology.sensor.camera import Camera
from crenel.metrology.sensor.laser_plane import LaserPlane
from crenel.metrology.transforms import Floats, apply
from crenel.station.view3d.meshes import (
    Mesh,
    box,
    flat_mesh,
    join_meshes,
    link_meshes,
    measuring_field,
    reach_mm,
    tube,
)
from crenel.station.view3d.nodes import M_PER_MM, Colour, add_mesh, viser_pose

LINK: Colour = (214, 218, 224)
HUB: Colour = (66, 74, 86)
ACCENT: Colour = (38, 132, 190)
RUBY: Colour = (190, 28, 52)
LASER: Colour = (232, 38, 46)
IDLE: Colour = (140, 146, 154)
IN_RANGE: Colour = (28, 160, 92)
OUT_OF_RANGE: Colour = LASER
# Radii as shares of the arm's reach, at its shoulder and at its wrist.
THICK, THIN = 0.026, 0.013
IDLE_OPACITY, LIT_OPACITY = 0.10, 0.24
SENSOR_HALF_MM = np.array([32.0, 24.0, 40.0])


class Removable(Protocol):
    def remove(self) -> None: ...


class ArmNode:
    """Nested nodes, one per link, so that a pose is one small message per joint."""

    def __init__(self, server: viser.ViserServer, arm: AnyArm) -> None:
        self._server = server
        self._links: list[viser.FrameHandle] = []
        self._sensor: list[Removable] = []
        self._field: viser.MeshHandle | None = None
        self._rim: viser.LineSegmentsHandle | None = None
        self._looks: tuple[bool, bool | None] = (False, None)
        self._root = server.scene.add_frame("/arm", show_axes=False)
        with server.atomic():
            self._build(arm)

    def remove(self) -> None:
        """Removes the arm and its sensor."""
        self._root.remove()

    def show(self, on: bool) -> None:
        """Shows the arm with its sensor, or hides it."""
        self._root.visible = on

    def pose(self, links: Floats) -> None:
        """Moves every link to ``A_i E_i`` (n, 4, 4) of Eq. 2-3; of an arm that reports poses, its
        flange to ``T_arm_flange`` (1, 4, 4)."""
        with self._server.atomic():
            for handle, position, wxyz in zip(self._links, *viser_pose(links), strict=True):
                handle.position, handle.wxyz = position, wxyz

    def _build(self, arm: AnyArm) -> None:
        reach = reach_mm(arm)
        if isinstance(arm, Arm):
            radii = reach * np.linspace(THICK, THIN, arm.joint_count + 1)
            self._build_links(arm, radii)
        else:
            radii = reach * np.array([THICK, THIN])
            self._build_flange(float(radii[-1]))
        foot = tube(np.zeros(3), np.array([0, 0, 0.5 * radii[0]]), 2.4 * radii[0], 2.2 * radii[0])
        add_mesh(self._server, "/arm/foot", foot, HUB)
        if arm.tip is not None:
            self._add_probe(arm.tip, float(radii[-1]))

    def _build_flange(self, radius_mm: float) -> None:
        """A disc: the links of an arm that reports poses are unknown."""
        self._flange = "/arm/1"
        self._links.append(self._server.scene.add_frame(self._flange, show_axes=False))
        disc = tube(np.array([0, 0, -radius_mm]), np.zeros(3), 2.6 * radius_mm, 2.6 * radius_mm)
        add_mesh(self._server, f"{self._flange}/disc", disc, HUB)

    def _build_links(self, arm: Arm, radii: Floats) -> None:
        path = "/arm"
        for i, joint in enumerate(arm.joints):
            path += f"/{i + 1}"
            self._links.append(self._server.scene.add_frame(path, show_axes=False))
            tubes, hub = link_meshes(joint, float(radii[i]), float(radii[i + 1]))
            if tubes is not None:
                add_mesh(self._server, f"{path}/tube", tubes, LINK)
            if i > 0:  # the first joint turns in the base
                add_mesh(self._server, f"{path}/hub", hub, HUB)
        self._flange = path

    def _add_probe(self, tip: Tip, radius_mm: float) -> None:
        centre = tip.centre_mm
        length = float(np.linalg.norm(centre))
        if length > tip.radius_mm:
            middle = 0.55 * centre
            handle = tube(np.zeros(3), middle, 0.8 * radius_mm, 0.5 * radius_mm)
            stem = tube(middle, centre, 0.25 * radius_mm, 0.6 * tip.radius_mm)
            add_mesh(self._server, f"{self._flange}/probe", handle, HUB)
            add_mesh(self._server, f"{self._flange}/stem", stem, LINK)
        self._server.scene.add_icosphere(
            f"{self._flange}/tip",
            radius=tip.radius_mm * M_PER_MM,
            color=RUBY,
            position=centre * M_PER_MM,
            cast_shadow=False,
            receive_shadow=False,
        )

    def set_sensor(
        self,
        T_flange_sensor: Floats,
        camera: Camera,
        plane: LaserPlane,
        depth_range_mm: tuple[float, float],
    ) -> None:
        """Draws a housing behind the camera centre, and the field in which the laser measures."""
        self.clear_sensor()
        centre = apply(T_flange_sensor, camera.centre_mm[None])[0]
        R_flange_cam = T_flange_sensor[:3, :3] @ camera.rotation.T
        housing = _housing(centre, R_flange_cam)
        bracket = tube(np.zeros(3), centre - 40.0 * R_flange_cam[:, 2], 9.0, 9.0)
        name = f"{self._flange}/sensor"
        self._sensor = [
            add_mesh(self._server, f"{name}/housing", housing, HUB, flat_shading=True),
            add_mesh(self._server, f"{name}/bracket", bracket, LINK),
            add_mesh(self._server, f"{name}/lens", _lens(centre, R_flange_cam), ACCENT),
        ]
        outline = measuring_field(camera, plane, depth_range_mm)
        if len(outline) >= 3:
            self._add_field(name, apply(T_flange_sensor, outline))

    def clear_sensor(self) -> None:
        for handle in self._sensor:
            handle.remove()
        self._sensor, self._field, self._rim = [], None, None

    def set_laser(self, on: bool, in_range: bool | None) -> None:
        """Colours the field: its rim red while the laser is on; its inside green if the stripe is
        within it, red if not, and grey if no stripe is measured."""
        if self._field is None or self._rim is None or (on, in_range) == self._looks:
            return
        self._looks = (on, in_range)
        inside = IDLE if in_range is None else IN_RANGE if in_range else OUT_OF_RANGE
        self._field.color = inside
        self._field.opacity = IDLE_OPACITY if in_range is None else LIT_OPACITY
        self._rim.colors = np.array(LASER if on else IDLE, dtype=np.uint8)

    def _add_field(self, name: str, outline_mm: Floats) -> None:
        self._looks = (False, None)
        self._field = add_mesh(
            self._server,
            f"{name}/field",
            flat_mesh(outline_mm),
            IDLE,
            opacity=IDLE_OPACITY,
            both_sides=True,
        )
        around = np.stack([outline_mm, np.roll(outline_mm, -1, axis=0)], axis=1) * M_PER_MM
        self._rim = self._server.scene.add_line_segments(
            f"{name}/rim",
            around.astype(np.float32),
            IDLE,
            thickness=1.5,
            thickness_units="screen",
        )
        self._sensor += [self._field, self._rim]


def _housing(centre_mm: Floats, R_flange_cam: Floats) -> Mesh:
    """A box around the camera centre, opening along its view."""
    low = -SENSOR_HALF_MM - np.array([0.0, 0.0, SENSOR_HALF_MM[2]])
    mesh = box(low, SENSOR_HALF_MM - np.array([0.0, 0.0, SENSOR_HALF_MM[2]]))
    return Mesh(mesh.vertices_mm @ R_flange_cam.T + centre_mm, mesh.faces)


def _lens(centre_mm: Floats, R_flange_cam: Floats) -> Mesh:
    view = R_flange_cam[:, 2]
    rim = tube(centre_mm, centre_mm + 6.0 * view, 13.0, 12.0)
    return join_meshes(rim, tube(centre_mm + 6.0 * view, centre_mm + 6.5 * view, 9.0, 9.0))
