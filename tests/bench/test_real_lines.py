"""The local noise of a line, on lines whose noise is known, and on real ones."""

from pathlib import Path

import cv2
import numpy as np
import pytest

from app.bench.stripe.real_lines import local_noise_px, run
from app.errors import OperationError


def test_noise_is_estimated_without_the_curve() -> None:
    u = np.arange(2000.0)
    curve = 500 + 1e-4 * (u - 900) ** 2
    assert local_noise_px((u, curve), 2000) < 1e-6
    noisy = curve + np.random.default_rng(1).normal(0, 0.05, 2000)
    assert local_noise_px((u, noisy), 2000) == pytest.approx(0.05, rel=0.05)
    assert np.isnan(local_noise_px((u[::2], noisy[::2]), 2000))


def test_real_lines_are_below_the_limit(real: Path) -> None:
    (row,) = run(real / "robot-laser-chessboard" / "calib1")
    assert float(row.crenel.split()[0]) < 0.07
    assert float(row.opencv.split()[0]) > float(row.crenel.split()[0])


def test_a_folder_without_pictures_is_refused(tmp_path: Path) -> None:
    with pytest.raises(OperationError, match="contains no pictures"):
        run(tmp_path)
    with pytest.raises(OperationError, match="no such file"):
        run(tmp_path / "nowhere")
    colour = np.zeros((20, 20, 3), np.uint8)
    colour[..., 1] = 9
    cv2.imwrite(str(tmp_path / "a.png"), colour)
    with pytest.raises(OperationError, match="in colour"):
        run(tmp_path)
    (tmp_path / "a.png").write_bytes(b"no picture")
    with pytest.raises(OperationError, match="not a picture of 8 bits"):
        run(tmp_path)
