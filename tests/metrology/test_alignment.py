"""The object's frame from contact points: found, judged, and refused."""

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from crenel.errors import OperationError
from crenel.metrology.probing.alignment import align, refuse_wrong_faces
from crenel.metrology.probing.contacts import missing_contacts
from crenel.metrology.targets.crenellated_block import probing_face
from crenel.metrology.transforms import Floats, inverse, vector_from_rotation
from tests.metrology.builders import BLOCK, TIP_RADIUS_MM, contacts_on, random_pose
from tests.metrology.refusals import refusal_of
from tests.uncertainty_ratio import EXACT, ratio_of_pulls, ratio_of_rms

pytestmark = pytest.mark.slow

FACE_SETS = (
    ("crest", "front", "left"),
    ("crest", "front", "right"),
    ("floor", "back", "left"),
    ("crest", "floor", "front", "back", "left", "right"),
)


@settings(max_examples=40, deadline=None)
@given(st.integers(0, 10**6), st.sampled_from(FACE_SETS))
def test_exact_contacts_give_the_exact_pose(seed: int, faces: tuple[str, ...]) -> None:
    rng = np.random.default_rng(seed)
    T_arm_obj = random_pose(rng)
    features, tips = contacts_on(rng, T_arm_obj, faces=faces)
    found = align(features, tips, TIP_RADIUS_MM, BLOCK)
    np.testing.assert_allclose(found.T_arm_obj, T_arm_obj, atol=1e-6)
    assert np.max(np.abs(found.residuals_mm)) < 1e-6


def test_the_covariance_predicts_the_scatter() -> None:
    rng = np.random.default_rng(2)
    T_arm_obj = random_pose(rng)
    errors, covariances = [], []
    features, exact = contacts_on(rng, T_arm_obj, per_face=15)
    normals = np.array([_normal_arm(T_arm_obj, face) for face in features])
    for _ in range(300):
        tips = exact + normals * rng.normal(0, 0.01, len(exact))[:, None]
        found = align(features, tips, TIP_RADIUS_MM, BLOCK)
        change = found.T_arm_obj @ inverse(T_arm_obj)
        shift = change[:3, :3] @ found.centre_mm + change[:3, 3] - found.centre_mm
        errors.append(np.concatenate([vector_from_rotation(change[:3, :3]), shift]))
        covariances.append(found.covariance)
    covariance = np.mean(covariances, axis=0)
    for claimed, observed in zip(np.sqrt(np.diag(covariance)), np.std(errors, axis=0), strict=True):
        ratio_of_rms(claimed, observed, len(errors)).assert_within(*EXACT)
    whitened = np.linalg.solve(np.linalg.cholesky(covariance), np.transpose(errors))
    ratio_of_pulls(whitened.T).assert_within(*EXACT)


def test_contacts_are_weighed_by_the_encoders_noise() -> None:
    rng = np.random.default_rng(4)
    T_arm_obj = random_pose(rng)
    features, exact = contacts_on(rng, T_arm_obj, per_face=15)
    sds = rng.choice([0.002, 0.05], len(features))
    covariances = np.array([np.eye(3) * sd**2 for sd in sds])
    plain: list[float] = []
    weighed: list[float] = []
    for _ in range(20):
        tips = exact + rng.normal(size=exact.shape) * sds[:, None]
        for out, noise in ((plain, None), (weighed, covariances)):
            T = align(features, tips, TIP_RADIUS_MM, BLOCK, noise).T_arm_obj
            out.append(float(np.linalg.norm((T @ inverse(T_arm_obj))[:3, :3] - np.eye(3))))
    assert np.mean(weighed) < 0.6 * np.mean(plain)


def test_a_slipped_contact_is_named_and_left_out() -> None:
    rng = np.random.default_rng(6)
    T_arm_obj = random_pose(rng)
    features, tips = contacts_on(rng, T_arm_obj, noise_mm=0.005)
    tips[17] += 0.3 * _normal_arm(T_arm_obj, features[17])
    found = align(features, tips, TIP_RADIUS_MM, BLOCK)
    assert list(np.flatnonzero(found.outliers)) == [17]
    assert found.residuals_mm[17] == pytest.approx(0.3, abs=0.03)
    np.testing.assert_allclose(found.T_arm_obj, T_arm_obj, atol=0.2)
    refuse_wrong_faces(found, features, BLOCK)


@pytest.mark.parametrize("bad_mm", [0.0, 0.2])
def test_contacts_of_a_posture_turned_over_are_no_outliers_of_the_others(bad_mm: float) -> None:
    rng = np.random.default_rng(20)
    T_arm_obj = random_pose(rng)
    features, tips = contacts_on(rng, T_arm_obj, noise_mm=0.002)
    turned_over = np.arange(len(tips)) % 18 == 17
    shared = np.zeros((len(tips), 3, 3))
    shared[turned_over] = 0.04 * np.eye(3)
    tips[turned_over] += T_arm_obj[:3, :3] @ [-0.05, -0.06, 0.05]
    tips[7] += bad_mm * _normal_arm(T_arm_obj, features[7])
    noise = np.tile(0.002**2 * np.eye(3), (len(tips), 1, 1))
    found = align(features, tips, TIP_RADIUS_MM, BLOCK, noise, shared)
    assert np.flatnonzero(found.outliers | found.doubtful).tolist() == ([7] if bad_mm else [])
    unaware = align(features, tips, TIP_RADIUS_MM, BLOCK, noise)
    assert set(np.flatnonzero(unaware.outliers | unaware.doubtful)) - {7}


@pytest.mark.parametrize("seed", range(6))
def test_a_first_point_in_the_air_is_the_only_one_accused(seed: int) -> None:
    rng = np.random.default_rng(900 + seed)
    features, tips = contacts_on(rng, random_pose(rng), per_face=9, noise_mm=0.02)
    away = rng.normal(size=3)
    tips[0] += away / np.linalg.norm(away) * rng.uniform(100, 500)
    found = align(features, tips, TIP_RADIUS_MM, BLOCK)
    assert list(np.flatnonzero(found.outliers)) == [0]


def touched(seed: int) -> tuple[list[str], Floats]:
    """Contacts on a block anywhere."""
    rng = np.random.default_rng(seed)
    return contacts_on(rng, random_pose(rng), noise_mm=0.005)


def test_a_contact_on_a_wrong_face_is_refused_by_name() -> None:
    features, tips = touched(7)
    features[20] = "crest"  # it was taken on the front face
    found = align(features, tips, TIP_RADIUS_MM, BLOCK)
    with pytest.raises(OperationError, match=r"contact point 21 is labelled crest.*front"):
        refuse_wrong_faces(found, features, BLOCK)


@pytest.mark.parametrize(
    "by_wrong_arm",
    [2 * np.eye(3), np.array([[1.0, 0.1, 0.0], [0.0, 1.0, 0.1], [0.1, 0.0, 1.0]])],
    ids=["twice", "skew"],
)
def test_an_arm_that_measures_wrongly_is_not_put_on_one_contact(by_wrong_arm: Floats) -> None:
    features, tips = contacts_on(np.random.default_rng(9), np.eye(4), noise_mm=0.005)

    def judged() -> None:
        found = align(features, tips @ by_wrong_arm.T, TIP_RADIUS_MM, BLOCK)
        refuse_wrong_faces(found, features, BLOCK)

    refusal = refusal_of(judged)
    assert refusal.code == "contacts-do-not-fit"
    assert "Check the arm's file" in refusal.line


@pytest.mark.parametrize(
    "swap",
    [{"left": "right"}, {"front": "back"}, {"crest": "floor"}, {"crest": "front", "front": "left"}],
)
def test_a_whole_face_mislabelled_is_refused(swap: dict[str, str]) -> None:
    features, tips = touched(8)
    with pytest.raises(OperationError, match=r"labelled|not determine"):
        align([swap.get(face, face) for face in features], tips, TIP_RADIUS_MM, BLOCK)


@pytest.mark.parametrize(
    ("taken", "called"),
    [
        ("crest", "floor"),
        ("front", "back"),
        ("left", "right"),
        ("front", "right"),
        ("left", "back"),
    ],
)
@pytest.mark.parametrize("count", [1, 3])
def test_contacts_on_an_own_face_are_refused_by_name(taken: str, called: str, count: int) -> None:
    features, tips = touched(12)
    first = features.index(taken) + 4
    features[first : first + count] = [called] * count
    found = align(features, tips, TIP_RADIUS_MM, BLOCK)
    assert list(np.flatnonzero(found.outliers)) == list(range(first, first + count))
    said = rf"contact point {first + 1} is labelled {called}.*lies on the {taken} face"
    with pytest.raises(OperationError, match=said):
        refuse_wrong_faces(found, features, BLOCK)


def test_faces_that_only_a_drawing_gives_are_found_with_the_pose() -> None:
    rng = np.random.default_rng(21)
    tolerance_mm = 0.1
    drawing = replace(BLOCK, standard_uncertainty_mm=tolerance_mm / np.sqrt(3), is_nominal=True)
    edges = (BLOCK.edges_x_mm[0] - 0.07, *BLOCK.edges_x_mm[1:-1], BLOCK.edges_x_mm[-1] + 0.06)
    made = replace(BLOCK, edges_x_mm=edges, crest_z_mm=BLOCK.crest_z_mm + 0.05)
    faces = ("crest", "front", "left", "right")
    T_arm_obj = random_pose(rng)
    features, tips = contacts_on(rng, T_arm_obj, faces=faces, noise_mm=0.004, block=made)
    slipped = features.index("right") + 2
    tips[slipped] += 0.05 * T_arm_obj[:3, 0]
    found = align(features, tips, TIP_RADIUS_MM, drawing)
    assert list(np.flatnonzero(found.outliers)) == [slipped]
    assert found.rms_mm < 0.006
    off_mm = found.face_offsets_mm
    assert off_mm["left"] + off_mm["right"] == pytest.approx(0.13, abs=0.01)
    certified = align(features, tips, TIP_RADIUS_MM, BLOCK)
    assert certified.rms_mm > 0.03
    assert not certified.face_offsets_mm


def test_a_block_taken_for_itself_turned_half_round_is_refused() -> None:
    features, tips = touched(13)
    turned = {"front": "back", "left": "right", "crest": "crest"}
    with pytest.raises(OperationError, match="mirrored order"):
        align([turned[face] for face in features], tips, TIP_RADIUS_MM, BLOCK)
    mirrored = replace(BLOCK, edges_x_mm=tuple(-x for x in reversed(BLOCK.edges_x_mm)))
    with pytest.raises(OperationError, match="mirrored order"):
        align(features, tips, TIP_RADIUS_MM, mirrored)


def test_missing_faces_are_said() -> None:
    missing = str(missing_contacts(["crest"] * 5 + ["front"] * 3))
    assert missing == "Touch 3 more on the left or the right face"
    assert missing_contacts(["crest"] * 3 + ["back"] * 3 + ["left", "right", "left"]) == ""
    rng = np.random.default_rng(9)
    features, tips = contacts_on(rng, random_pose(rng), faces=("crest", "front"))
    with pytest.raises(OperationError, match="Touch 3 more on the left or the right"):
        align(features, tips, TIP_RADIUS_MM, BLOCK)


def test_contacts_on_one_line_are_refused() -> None:
    features, tips = contacts_on(np.random.default_rng(10), np.eye(4))
    line = np.array(features) == "crest"
    tips[line, 1] = 3.0
    with pytest.raises(OperationError, match=r"crest face lie on one line.*beside that line"):
        align(features, tips, TIP_RADIUS_MM, BLOCK)
    block = replace(BLOCK, front_y_mm=1.2, back_y_mm=4.8)
    features, tips = contacts_on(np.random.default_rng(10), np.eye(4), block=block)
    tips[line, 1] = 3.0 + np.random.default_rng(11).normal(0.0, 0.05, line.sum())
    with pytest.raises(OperationError, match="crest face lie on one line"):
        align(features, tips, TIP_RADIUS_MM, block)


def test_an_unknown_face_and_bad_numbers_are_refused() -> None:
    features, tips = contacts_on(np.random.default_rng(11), np.eye(4))
    with pytest.raises(OperationError, match="unknown face 'lid'"):
        align(["lid", *features[1:]], tips, TIP_RADIUS_MM, BLOCK)
    tips[3, 1] = np.nan
    with pytest.raises(OperationError, match="positions"):
        align(features, tips, TIP_RADIUS_MM, BLOCK)


def _normal_arm(T_arm_obj: np.ndarray, face: str) -> np.ndarray:
    return T_arm_obj[:3, :3] @ probing_face(BLOCK, face)[0]
