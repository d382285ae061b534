"""The operator's datasheets: what the makers of arm, block, sensor and gauges state of them.

Plain dictionaries, in the files' own layout; true errors are not in them.
"""

import json
from collections.abc import Sequence
from pathlib import Path

import numpy as np

from crenel_hardware.simulator.devices.kinematics import ArmModel, Floats
from crenel_hardware.simulator.scene.camera import LightPlane, Optics, to_pixels
from crenel_hardware.simulator.scene.world import Board, CrenellatedBlock, GaugeSphere

JsonObject = dict[str, object]

NO_EXPANSION: JsonObject = {"expansion_per_c": 0.0, "expansion_sd_per_c": 1e-8}
"""The simulated gauges keep their size at any temperature: a true zero has an uncertainty."""
BOARD_FLATNESS_MM = 0.005
"""By how much the maker of a chessboard says that it may bend."""


def arm_datasheet(arm: ArmModel) -> JsonObject:
    """arm.json of the arm as it was meant to be."""
    joints = []
    for i, link in enumerate(arm.links):
        joints.append(
            {
                "name": f"J{i + 1}",
                "a_mm": link.a_mm,
                "alpha_deg": float(np.degrees(link.alpha_rad)),
                "d_mm": link.d_mm,
                "theta_deg": float(np.degrees(link.theta_rad)),
                "sign": link.sign,
                "limits_deg": [float(np.degrees(limit)) for limit in link.limits_rad],
                "encoder_sd_deg": float(np.degrees(arm.encoder_sd_rad)),
            }
        )
    return {**robot_datasheet(arm), "convention": "dh-standard", "joints": joints}


def robot_datasheet(arm: ArmModel, tip: bool = True) -> JsonObject:
    """arm.json of an arm whose controller reports poses; without a tip, it touches nothing."""
    x, y, z = arm.tip_mm
    mounted = {"tip": {"x_mm": x, "y_mm": y, "z_mm": z, "diameter_mm": arm.tip_diameter_mm}}
    return {
        "format": "crenel/arm",
        "version": 1,
        "name": arm.name,
        "serial_number": arm.serial_number,
        "convention": "pose",
        **(mounted if tip else {}),
    }


def block_datasheet(
    certificate: CrenellatedBlock,
    standard_uncertainty_mm: float,
    name: str = "Simulated crenellated block",
    serial_number: str = "TWIN-B1",
) -> JsonObject:
    """object.json as the block's certificate has it."""
    return {
        "format": "crenel/object",
        "version": 1,
        "name": name,
        "serial_number": serial_number,
        "certificate": "simulated",
        "edges_x_mm": list(certificate.edges_x_mm),
        "front_y_mm": certificate.front_y_mm,
        "back_y_mm": certificate.back_y_mm,
        "crest_z_mm": certificate.crest_z_mm,
        "floor_z_mm": certificate.floor_z_mm,
        "base_z_mm": certificate.base_z_mm,
        "standard_uncertainty_mm": standard_uncertainty_mm,
    }


def board_datasheet(
    certificate: Board,
    standard_uncertainty_mm: float,
    name: str = "Simulated chessboard",
    serial_number: str = "TWIN-C1",
) -> JsonObject:
    """The file of an object as the chessboard's certificate has it; its squares are square."""
    common: JsonObject = {
        "format": "crenel/object",
        "version": 1,
        "name": name,
        "serial_number": serial_number,
        "certificate": "simulated",
        "square_mm": certificate.square_x_mm,
        "standard_uncertainty_mm": standard_uncertainty_mm,
        "flatness_mm": BOARD_FLATNESS_MM,
    }
    columns, rows = certificate.inner_corners
    markers = certificate.markers
    if markers is None:
        return {**common, "kind": "chessboard", "inner_corners": [columns, rows]}
    return {
        **common,
        "kind": "charuco",
        "squares_x": columns + 1,
        "squares_y": rows + 1,
        "marker_mm": markers.side * certificate.square_x_mm,
        "dictionary": markers.dictionary,
    }


def sensor_datasheet(
    optics: Optics,
    light_plane: LightPlane,
    name: str = "Simulated stripe sensor",
    serial_number: str = "TWIN-S1",
) -> JsonObject:
    """sensor.json: the image's size and the way that the stripe runs in it."""
    return {
        "format": "crenel/sensor",
        "version": 1,
        "name": name,
        "serial_number": serial_number,
        "width_px": optics.width_px,
        "height_px": optics.height_px,
        "stripe_axis": stripe_axis(optics, light_plane),
        "laser_wavelength_nm": 660,
    }


def stripe_axis(optics: Optics, light_plane: LightPlane) -> str:
    """ "u" where the stripe has one point a column, "v" where it has one a row."""
    along = np.cross(light_plane.normal, [0.0, 0.0, 1.0])
    middle = np.array(light_plane.normal) * light_plane.offset_mm
    ends = to_pixels(optics, np.stack([middle - 5 * along, middle + 5 * along]))
    du, dv = np.abs(ends[1] - ends[0])
    return "u" if du >= dv else "v"


GAUGE_SD_MM = 0.0005
"""The standard deviation of lengths of step gauge and ball bar, as their certificates have it."""


def plane_nominal(point_mm: Floats, normal: Floats, width_mm: float) -> JsonObject:
    """*.nominal.json of a gauge plane, in the arm frame."""
    return {
        "format": "crenel/nominal",
        "version": 1,
        "shape": "plane",
        "point_mm": [float(value) for value in point_mm],
        "normal": [float(value) for value in normal],
        "name": "Simulated gauge plate",
        "serial_number": "TWIN-P1",
        "certificate": "simulated",
        "standard_uncertainty_um": 0.5,
        "form_um": 1.0,
        "width_mm": width_mm,
    }


def sphere_nominal(centre_mm: Floats, ball: GaugeSphere) -> JsonObject:
    """*.nominal.json of a gauge sphere, in the arm frame."""
    return {
        "format": "crenel/nominal",
        "version": 1,
        "shape": "sphere",
        "centre_mm": [float(value) for value in centre_mm],
        "radius_mm": ball.radius_mm,
        "name": "Simulated gauge sphere",
        "serial_number": "TWIN-K1",
        "certificate": "simulated",
        "standard_uncertainty_um": 0.3,
        "form_um": 1.0,
        **NO_EXPANSION,
    }


def write_document(path: Path, document: JsonObject) -> None:
    """Writes one document as JSON."""
    path.write_text(json.dumps(document, indent=1) + "\n", encoding="utf-8")


def write_table(path: Path, header: Sequence[str], rows: Sequence[Sequence[object]]) -> None:
    """Writes a comma-separated table with one header row."""
    lines = [",".join(header)] + [",".join(str(cell) for cell in row) for row in rows]
    path.write_text("\n".join(lines) + "\n", encoding="utf-8")
