"""Arms and blocks that the tests of the mathematics share."""

import numpy as np

from crenel.metrology.arm.kinematics import Arm, Joint, Tip
from crenel.metrology.arm.link_error import LinkError
from crenel.metrology.targets.crenellated_block import Crenellated, probing_face
from crenel.metrology.transforms import Floats, apply, rigid, rotation_from_vector

BLOCK = Crenellated(
    name="block",
    serial_number="B-7",
    edges_x_mm=(-25.0, -16.0, -10.0, -3.0, 4.0, 8.0, 15.0, 21.0),
    front_y_mm=-11.0,
    back_y_mm=13.0,
    crest_z_mm=16.0,
    floor_z_mm=0.0,
    base_z_mm=-11.0,
    standard_uncertainty_mm=0.002,
)
TIP_RADIUS_MM = 1.5


def random_arm(rng: np.random.Generator, joints: int = 6, with_errors: bool = False) -> Arm:
    """An arm of ordinary proportions with every parameter off its round value."""
    links = []
    for i in range(joints):
        error = LinkError()
        if with_errors:
            error = LinkError(*rng.normal(0, 0.05, 3), *rng.normal(0, 2e-4, 3))
        links.append(
            Joint(
                name=f"J{i + 1}",
                a_mm=float(rng.uniform(-50, 50)),
                alpha_rad=float(rng.choice([-1, 1]) * np.pi / 2 + rng.normal(0, 0.01)),
                d_mm=float(rng.uniform(0, 500)),
                theta_rad=float(rng.uniform(-np.pi, np.pi)),
                sign=int(rng.choice([-1, 1])),
                encoder_sd_rad=1e-5,
                error=error,
            )
        )
    return Arm("arm", "A-3", tuple(links), Tip(2.0, -9.0, 140.0, 2 * TIP_RADIUS_MM))


def six_axis_arm(encoder_sd_rad: float) -> Arm:
    """An arm without errors, its tip on the axis of the last joint."""
    shape = [(0, -90, 280), (450, 0, 0), (60, -90, 0), (0, 90, 400), (0, -90, 0), (0, 0, 90)]
    joints = tuple(
        Joint(f"J{i + 1}", a, np.radians(alpha), d, 0.0, encoder_sd_rad=encoder_sd_rad)
        for i, (a, alpha, d) in enumerate(shape)
    )
    return Arm("test arm", "A-1", joints, Tip(0.0, 0.0, 120.0, 6.0))


def random_pose(rng: np.random.Generator) -> Floats:
    """A rigid transform (4, 4) anywhere in an arm's reach."""
    return rigid(rotation_from_vector(rng.normal(0, 1.5, 3)), rng.uniform(-600, 600, 3))


def contacts_on(
    rng: np.random.Generator,
    T_arm_obj: Floats,
    per_face: int = 12,
    faces: tuple[str, ...] = ("crest", "front", "left"),
    noise_mm: float = 0.0,
    block: Crenellated = BLOCK,
) -> tuple[list[str], Floats]:
    """Features (N) and tip centres (N, 3) in the arm frame of touches spread over faces."""
    features: list[str] = []
    centres = []
    x, y = block.edges_x_mm, (block.front_y_mm, block.back_y_mm)
    for face in faces:
        normal, offset_mm = probing_face(block, face)
        for k in range(per_face):
            # a floor lies between merlon and merlon
            grooves = block.merlon_count - 1
            left = 2 * (k % grooves) + 1 if face == "floor" else 2 * (k % block.merlon_count)
            across = rng.uniform(x[left], x[left + 1]), rng.uniform(*y)
            point = np.array([*across, rng.uniform(block.base_z_mm, block.crest_z_mm)])
            along = np.abs(normal) > 0.5
            point[along] = (normal * offset_mm)[along]
            features.append(face)
            centres.append(point + normal * (TIP_RADIUS_MM + rng.normal(0, noise_mm)))
    return features, apply(T_arm_obj, np.array(centres))
