"""Certificates of blocks by the tip of an arm, beside the truth; exchanged touches are named.

    python -m tests.bench block-certificate [--blocks 50] [--first 52000] [--json]

Each block, made within ± 0.1 mm, stands on the table before an arm drawn at random, whose links are
off its file by 20 µm rms of the tip over the reach, and the tip's centre with them. The operator
touches each wall, front, back, crests, floor and the table four times. Of every second block, the
tip's diameter is certified to 2 µm; of the others it is off by 20 µm rms and unknown, and a
micrometer measures the overall width. The uncertainty that the certificate claims is compared with
its errors. Then two touches, of faces drawn at random, are exchanged.
"""

import tempfile
from collections.abc import Iterator
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

from crenel.errors import OperationError
from crenel.formats.certifying.block_certificate import BlockCertificate, certify_block
from crenel.formats.certifying.block_points import TouchingArm, read_touching_arm
from crenel.formats.csv_table import table_text
from crenel.formats.session.pose_columns import joint_columns
from crenel.metrology.transforms import Floats
from crenel_hardware.simulator.devices.kinematics import (
    ArmModel,
    UnreachableError,
    perturb_arm,
    solve_joints,
)
from crenel_hardware.simulator.operator.contact import (
    choose_contact_point,
    contact_pose,
    faces_to_certify,
)
from crenel_hardware.simulator.scene.datasheets import (
    arm_datasheet,
    block_datasheet,
    write_document,
)
from crenel_hardware.simulator.scene.random_scenes import (
    draw_true_block,
    random_arm,
    random_block,
    random_block_pose,
)
from crenel_hardware.simulator.scene.world import CrenellatedBlock
from tests.bench.rows import Rows, bench_parser, measured_rows, rms

TOLERANCE_MM, ARM_UM, TOUCH_MM = 0.1, 20.0, 0.006
ON_FACE = 4
TIPS_MM = (1.0, 1.5, 2.0, 3.0)
ROOM_MM = 0.6
"""A groove leaves the tip so much at least."""
CERTIFIED_UM, OFF_MM = 2.0, 0.02
MICROMETER_MM = 0.002
TRIES = 20


@dataclass(frozen=True)
class TouchedBlock:
    """A block as truly made, and what its operator brings: files in a folder."""

    true_mm: Floats
    """(B,) coordinates."""
    faces: tuple[str, ...]
    q_deg: Floats
    """(N, n)"""
    by: TouchingArm
    width_mm: float | None
    """By micrometer, where the tip's diameter is unknown."""
    edges: int


def draw_touched(seed: int, folder: Path) -> TouchedBlock:
    """A block that an arm touched, with its drawing and the arm's file in a folder."""
    for attempt in range(TRIES):
        rng = np.random.default_rng([seed, attempt])
        try:
            return _touch(seed, rng, folder)
        except UnreachableError:
            continue
    raise UnreachableError(f"no arm was found for block {seed}")


def _touch(seed: int, rng: np.random.Generator, folder: Path) -> TouchedBlock:
    drawn = random_block(rng)
    grooves = np.diff(drawn.edges_x_mm)[1::2]
    tip_mm = max(one for one in TIPS_MM if one <= grooves.min() - ROOM_MM)
    arm = replace(random_arm(rng, int(rng.integers(6, 8))), tip_diameter_mm=tip_mm)
    certified = seed % 2 == 0
    off_mm = rng.normal(0.0, CERTIFIED_UM / 1e3 if certified else OFF_MM)
    true_arm = replace(perturb_arm(arm, ARM_UM, rng), tip_diameter_mm=tip_mm + float(off_mm))
    made = draw_true_block(drawn, 0.0, rng, TOLERANCE_MM)
    faces = tuple(face for face in faces_to_certify(drawn) for _ in range(ON_FACE))
    q_rad = _touch_faces(true_arm, made, faces, rng)
    write_document(folder / "arm.json", arm_datasheet(arm))
    drawing = block_datasheet(drawn, 0.0)
    del drawing["standard_uncertainty_mm"]
    write_document(folder / "drawing.json", drawing | {"tolerance_mm": TOLERANCE_MM})
    by = read_touching_arm(folder / "arm.json", ARM_UM, CERTIFIED_UM if certified else None)
    width = made.edges_x_mm[-1] - made.edges_x_mm[0] + rng.normal(0.0, MICROMETER_MM)
    true_mm = [*made.edges_x_mm, made.front_y_mm, made.back_y_mm]
    true_mm += [made.crest_z_mm, made.floor_z_mm, made.base_z_mm]
    return TouchedBlock(
        np.array(true_mm),
        faces,
        np.degrees(q_rad),
        by,
        None if certified else float(width),
        len(made.edges_x_mm),
    )


def _touch_faces(
    arm: ArmModel, made: CrenellatedBlock, faces: tuple[str, ...], rng: np.random.Generator
) -> Floats:
    """(N, n) what the encoders say at each touch, in one posture if the arm can."""
    T, radius = random_block_pose(rng), arm.tip_diameter_mm / 2
    q, read = np.zeros(arm.joint_count), []
    for number, face in enumerate(faces):
        spot = choose_contact_point(made, face, number % ON_FACE, radius, rng)
        gap = radius + float(rng.normal(0.0, TOUCH_MM))
        q = solve_joints(arm, contact_pose(arm, T, face, spot, gap, rng), q, rng, attempts=12)
        read.append(q + rng.normal(0.0, arm.encoder_sd_rad, len(q)))
    return np.array(read)


def certify(touched: TouchedBlock, q_deg: Floats, folder: Path) -> BlockCertificate:
    """The certificate by joint angles (N, n) at the touches."""
    columns = ("face", *joint_columns(q_deg.shape[1]), "standard_uncertainty_mm")
    rows = [[face, *q, TOUCH_MM] for face, q in zip(touched.faces, q_deg.tolist(), strict=True)]
    (folder / "points.csv").write_text(table_text(columns, rows))
    readings = None
    if touched.width_mm is not None:
        readings = folder / "readings.csv"
        last = f"edge_{touched.edges}"
        head = ("from", "to", "distance_mm", "standard_uncertainty_mm")
        row: list[str | float] = ["edge_1", last, touched.width_mm, MICROMETER_MM]
        readings.write_text(table_text(head, [row]))
    return certify_block(
        folder / "drawing.json", readings, "by tip", folder / "points.csv", touched.by
    )


@dataclass(frozen=True)
class CertifiedBlock:
    """Errors and claims (B,) of one block, about the mean of each axis; whether a pair of exchanged
    touches was named."""

    off_mm: Floats
    claimed_mm: Floats
    edges: int
    certified_tip: bool
    exchanged: str


def measure_block(seed: int) -> CertifiedBlock | OperationError:
    """One block with its exchanged touches; a refusal if it gets no certificate."""
    with tempfile.TemporaryDirectory() as scratch:
        folder = Path(scratch)
        touched = draw_touched(seed, folder)
        try:
            made = certify(touched, touched.q_deg, folder)
        except OperationError as refusal:
            return refusal
        edges = touched.edges
        off = made.fit.coordinates_mm - touched.true_mm
        for own in (slice(0, edges), slice(edges, edges + 2), slice(edges + 2, edges + 5)):
            off[own] -= off[own].mean()
        claimed = np.sqrt(np.diag(made.fit.covariance_mm2))
        exchanged = exchange_two(touched, folder, np.random.default_rng([seed, TRIES]))
        return CertifiedBlock(off, claimed, edges, touched.width_mm is None, exchanged)


def exchange_two(touched: TouchedBlock, folder: Path, rng: np.random.Generator) -> str:
    """What is said of two touches, of different faces, whose angles are exchanged: ``named``,
    ``refused`` without naming both, or ``accepted``."""
    while True:
        i, j = (int(k) for k in rng.choice(len(touched.faces), 2, replace=False))
        if touched.faces[i] != touched.faces[j]:
            break
    q_deg = touched.q_deg.copy()
    q_deg[[i, j]] = q_deg[[j, i]]
    try:
        certify(touched, q_deg, folder)
    except OperationError as refusal:
        both = all(f"line {k + 2} ({_name(touched, k)})" in refusal.line for k in (i, j))
        return "named" if refusal.code == "touches-exchanged" and both else "refused"
    return "accepted"


def _name(touched: TouchedBlock, index: int) -> str:
    ends = {"left": "edge_1", "right": f"edge_{touched.edges}"}
    return ends.get(touched.faces[index], touched.faces[index])


def measure_blocks(count: int, first: int, rows: Rows) -> None:
    """Rows of all blocks, and of each kind of tip."""
    done = []
    for number, found in _each(count, first):
        if isinstance(found, OperationError):
            rows.say(f"{number}: refused: {found.line}")
        else:
            done.append(found)
            if found.exchanged != "named":
                rows.say(f"{number}: exchanged touches: {found.exchanged}")
    for name, some in (
        ("all blocks", done),
        ("tip certified", [one for one in done if one.certified_tip]),
        ("tip unknown, width by micrometer", [one for one in done if not one.certified_tip]),
    ):
        if some:
            rows.add(name, _row(some))
    named = sum(one.exchanged == "named" for one in done)
    rows.add(
        "exchanged touches", {"blocks": len(done), "named": named, "refused": count - len(done)}
    )


def _each(count: int, first: int) -> Iterator[tuple[int, CertifiedBlock | OperationError]]:
    return ((seed, measure_block(seed)) for seed in range(first, first + count))


def _row(some: list[CertifiedBlock]) -> dict[str, float]:
    off = np.concatenate([one.off_mm[: one.edges] for one in some])
    claimed = np.concatenate([one.claimed_mm[: one.edges] for one in some])
    others = np.concatenate([one.off_mm[one.edges :] for one in some])
    of_others = np.concatenate([one.claimed_mm[one.edges :] for one in some])
    squares = np.array([np.mean((one.off_mm / one.claimed_mm)[: one.edges] ** 2) for one in some])
    return {
        "edges, rms µm": 1e3 * rms(off),
        "claimed / observed": rms(claimed) / rms(off),
        "its standard error": float(np.std(squares) / np.mean(squares) / 2 / np.sqrt(len(some))),
        "other faces, rms µm": 1e3 * rms(others),
        "others, claimed / obs.": rms(of_others) / rms(others),
    }


def main() -> None:
    parser = bench_parser(__doc__)
    parser.add_argument("--blocks", type=int, default=50)
    parser.add_argument("--first", type=int, default=52000)
    given = parser.parse_args()
    with measured_rows(given.json) as rows:
        measure_blocks(given.blocks, given.first, rows)


if __name__ == "__main__":
    main()
