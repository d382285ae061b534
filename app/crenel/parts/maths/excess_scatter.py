"""What residuals of a scan show beyond every error that is known: form and vibration.

Residuals are gathered in runs of consecutive frames. The known errors, those that everything
shares as well, leave residuals of their own; only what exceeds them is new.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from crenel.metrology.transforms import Floats
from crenel.parts.maths.point_errors import ErrorSums, ScanErrors

RUNS, FEWEST_RUNS = 12, 10
CHANCE_SDS = 3.0
"""Residuals exceed what is known where chance shows so much in one of a thousand features."""


@dataclass(frozen=True)
class RunScatter:
    """What R runs of a feature's points pull at its m parameters.

    ``pulls`` (R, m) are found; ``by_shared`` (R, m, P) and ``by_noise`` (R, m, m), a covariance,
    are what known errors make of each run before the fit; ``normal`` (R, m, m) is each run's part
    of the normal matrix.
    """

    pulls: Floats
    by_shared: Floats
    by_noise: Floats
    normal: Floats

    def excess(self, shared: Floats) -> Floats:
        """(m, m) covariance of the parameters beyond what is known.

        Args:
            shared: (P, P) covariance of the shared errors.
        """
        runs, m = self.pulls.shape
        inverse = np.linalg.inv(self.normal.sum(axis=0))
        share = self.normal @ inverse  # of the whole pull, what the fit takes from each run
        left = self.by_shared - share @ self.by_shared.sum(axis=0)
        left = left.reshape(runs * m, -1)
        expected = left @ shared @ left.T + self._noise(share).reshape(runs * m, runs * m)
        blocks = expected.reshape(runs, m, runs, m)[np.arange(runs), :, np.arange(runs)]
        known = blocks.sum(axis=0)
        weight = np.linalg.inv(known)
        ratio = float(np.einsum("ri,ij,rj->", self.pulls, weight, self.pulls)) / m
        whole = (np.kron(np.eye(runs), weight) @ expected).reshape(runs * m, runs * m)
        sd = float(np.sqrt(2 * np.sum(whole * whole.T))) / m
        if ratio < 1 + CHANCE_SDS * sd:
            return np.zeros((m, m))
        freedom = runs / (runs - m)
        return np.asarray((ratio - 1) * freedom * inverse @ known @ inverse)

    def _noise(self, share: Floats) -> Floats:
        """(R, m, R, m) covariance of pulls after the fit by the noise of frames and points."""
        runs, m = self.pulls.shape
        taken = np.einsum("rij,sjk->risk", self.by_noise, np.swapaxes(share, 1, 2))
        total = np.einsum("rij,jk,slk->risl", share, self.by_noise.sum(axis=0), share)
        found = total - taken - np.einsum("risk->skri", taken)
        own = np.zeros((runs, m, runs, m))
        own[np.arange(runs), :, np.arange(runs)] = self.by_noise
        return np.asarray(found + own)


def sums_of_runs(
    errors: ScanErrors, J: Floats, normals: Floats, weights: Floats, off_mm: Floats, sd_mm: Floats
) -> tuple[ErrorSums, RunScatter | None]:
    """What a feature takes from the errors of its points, and what its runs show.

    Args:
        errors: the points (N).
        J, normals: (N, m) derivatives of the distances, (N, 3).
        weights, off_mm, sd_mm: (N,) weight, residual and own noise.

    Returns:
        The sums over all points, and the runs; no runs where there are too few frames.
    """
    run = _runs(errors.frame)
    m, count = J.shape[1], int(run.max()) + 1
    gains = J * weights[:, None]
    inverse = np.linalg.inv(gains.T @ J)
    pulls, noise, normal = [], [], []
    each: list[ErrorSums] = []
    for k in range(count):
        some = np.flatnonzero(run == k)
        sums = errors.select(some).sums(-gains[some], normals[some])
        by = sums.by_readings
        own = (gains[some] * sd_mm[some, None] ** 2).T @ gains[some]
        noise.append(np.einsum("kmi,kni->mn", by, by) + own)
        pulls.append(-gains[some].T @ off_mm[some])
        normal.append(gains[some].T @ J[some])
        each.append(sums)
    shared = np.array([one.shared for one in each])
    whole = ErrorSums(
        inverse @ shared.sum(axis=0),
        np.concatenate([one.frames for one in each]),
        inverse @ np.concatenate([one.by_readings for one in each]),
    )
    if count < max(FEWEST_RUNS, m + 2):
        return whole, None
    return whole, RunScatter(np.array(pulls), shared, np.array(noise), np.array(normal))


def _runs(frame: NDArray[np.int64]) -> NDArray[np.int64]:
    """The run (N,) of each point: whole frames, about equally many points each."""
    numbers, of_frame = np.unique(frame, return_inverse=True)
    before = np.concatenate([[0], np.cumsum(np.bincount(of_frame))[:-1]])
    wanted = min(RUNS, len(numbers))
    run_of_frame = np.minimum(before * wanted // len(frame), wanted - 1)
    return np.asarray(np.unique(run_of_frame, return_inverse=True)[1][of_frame], dtype=np.int64)
