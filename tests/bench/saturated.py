"""How well overexposed laser lines are placed: simulated and, where given, real ones.

    python -m tests.bench.saturated [REAL_FOLDER]

Simulated: a bent Gaussian line whose light is clipped at 255, read and shot noise. Beside
the rms error stand the Cramer-Rao bound of a single column and of as many columns as the
core is wide, and the rms of error / sigma. Real: the folder that holds
``robot-laser-chessboard``; there the noise is what 41 rows scatter by about a parabola.
The peers: the centroid of the clipped core; Gaussian blur and a parabola through the
highest pixel; both also averaged along the line over as many points as the core is wide.
"""

import sys
import time
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

import cv2
import numpy as np
from numpy.typing import NDArray

from app.metrology.stripe import Stripe, extract_stripe
from app.metrology.transforms import Floats

Grey = NDArray[np.uint8]
Line = tuple[Floats, Floats]  # points along and across

SEEDS = 8
READ, GAIN, BACKGROUND, WHITE = 2.0, 0.15, 20.0, 255.0
# Width in px and height in full scales of the simulated lines.
BEAMS = [(2.0, 2.0), (2.0, 4.0), (2.0, 8.0), (3.0, 4.0), (4.5, 8.0)]
ROWS = 41  # of the trend that is taken off real lines
NEAR_PX = 6.0  # of the line: nearer is a point of it, farther a false one
CONTRAST = 40.0  # grey levels over its surroundings from which the line counts as visible


def main() -> None:
    print_simulated()
    if len(sys.argv) > 1:
        for folder in sorted((Path(sys.argv[1]) / "robot-laser-chessboard").iterdir()):
            print_real(folder)


def centroid(image: Grey) -> Line:
    """Middle of the clipped pixels of every column."""
    clipped = image >= WHITE
    count = clipped.sum(axis=0)
    along = np.flatnonzero(count)
    rows = np.arange(image.shape[0], dtype=np.float64)
    return along.astype(np.float64), rows @ clipped[:, along] / count[along]


def fit_blurred_parabola(image: Grey) -> Line:
    """Vertex of the parabola through the highest pixel of every blurred column."""
    smooth = cv2.GaussianBlur(image.astype(np.float32), (1, 0), sigmaX=0.1, sigmaY=5.0)
    along = np.arange(image.shape[1])
    top = np.clip(smooth.argmax(axis=0), 1, image.shape[0] - 2)
    a, b, c = (smooth[top + k, along].astype(np.float64) for k in (-1, 0, 1))
    bend = a - 2 * b + c
    vertex = np.where(bend < 0, 0.5 * (a - c) / np.where(bend < 0, bend, 1.0), 0.0)
    return along.astype(np.float64), top + np.clip(vertex, -1, 1)


PEERS: list[tuple[str, Callable[[Grey], Line]]] = [
    ("clipped centroid", centroid),
    ("blur + parabola", fit_blurred_parabola),
]


def average_line(line: Line, width: int) -> Line:
    """The line averaged over ``width`` points (odd) that follow one another."""
    along, across = line
    half = width // 2
    mean = np.convolve(across, np.ones(width) / width, "valid")
    whole = along[2 * half :] - along[: len(along) - 2 * half] == 2 * half
    return along[half : len(along) - half][whole], mean[whole]


def core_width(image: Grey) -> int:
    """The usual number of clipped pixels in a column, made odd."""
    count = (image >= WHITE).sum(axis=0)
    return int(np.median(count[count > 0])) // 2 * 2 + 1


@dataclass(frozen=True)
class Simulated:
    """Errors in px of one beam over all seeds."""

    crenel: Floats
    sigma: Floats
    columns: int  # asked for
    core: int
    peers: list[tuple[Floats, Floats]]  # plain, averaged


def simulate_image(width_px: float, height: float, seed: int) -> tuple[Grey, Floats]:
    rng = np.random.default_rng(seed)
    u = np.arange(1280)
    centre = 200 + 40 * np.sin(u / 200 + seed) + 0.05 * u
    off = np.arange(400)[:, None] - centre
    light = BACKGROUND + height * WHITE * np.exp(-0.5 * (off / width_px) ** 2)
    noisy = light + rng.normal(size=light.shape) * np.sqrt(READ**2 + GAIN * light)
    return np.clip(np.rint(noisy), 0, WHITE).astype(np.uint8), centre


def simulate_beam(width_px: float, height: float) -> Simulated:
    crenel, sigma, core = [], [], 0
    peers: list[tuple[list[Floats], list[Floats]]] = [([], []) for _ in PEERS]
    for seed in range(SEEDS):
        image, centre = simulate_image(width_px, height, seed)
        core = core_width(image)
        stripe = extract_stripe(image)
        crenel.append(stripe.v - centre[stripe.u.astype(int)])
        sigma.append(stripe.sigma_px)
        for (plain, mean), (_, peer) in zip(peers, PEERS, strict=True):
            line = peer(image)
            for errors, (along, across) in ((plain, line), (mean, average_line(line, core))):
                errors.append(across - centre[along.astype(int)])
    return Simulated(
        np.concatenate(crenel),
        np.concatenate(sigma),
        SEEDS * 1280,
        core,
        [(np.concatenate(plain), np.concatenate(mean)) for plain, mean in peers],
    )


def bound_px(width_px: float, height: float) -> float:
    """Cramer-Rao bound of one column's centre from its pixels that are not clipped.

    Brightness and background are even functions about the centre and take nothing from
    it, on average over where the centre lies between two pixels.
    """
    information = []
    for phase in np.linspace(0, 1, 20, endpoint=False):
        off = np.arange(-60, 61) - phase
        signal = height * WHITE * np.exp(-0.5 * (off / width_px) ** 2)
        level = BACKGROUND + signal
        seen = level < WHITE
        slope = signal * off / width_px**2
        variance = READ**2 + GAIN * level + 1 / 12
        information.append(np.sum((slope**2 / variance)[seen]))
    return float(np.mean(np.array(information) ** -0.5))


def rms(x: Floats) -> float:
    return float(np.sqrt(np.mean(x**2)))


def print_simulated() -> None:
    print(f"simulated: rms error in px, {SEEDS} images of 1280 columns each")
    print(
        "  width  peak   core  bound  bound/core  crenel  mean     pull   found  "
        + "  ".join(f"{name} (averaged)" for name, _ in PEERS)
    )
    for width_px, height in BEAMS:
        got, bound = simulate_beam(width_px, height), bound_px(width_px, height)
        print(
            f"  {width_px:.1f}px {height:4.0f}x {got.core:5d}px  {bound:.4f}  "
            f"{bound / np.sqrt(got.core):.4f}      {rms(got.crenel):.4f}  "
            f"{np.mean(got.crenel):+.4f}  {rms(got.crenel / got.sigma):.3f}  "
            f"{100 * len(got.crenel) / got.columns:5.1f}%  "
            + "  ".join(f"{rms(p):.4f} ({rms(m):.4f})       " for p, m in got.peers)
        )


def line_path(image: Grey) -> tuple[Floats, NDArray[np.bool_]]:
    """Where the line runs in every row, and whether it is visible there; by brightness alone.

    The path of the most light from top to bottom, four columns a row at most.
    """
    smooth = cv2.GaussianBlur(image.astype(np.float32), (0, 0), 4.0)
    height, width = smooth.shape
    best, back = smooth[0].copy(), np.zeros((height, width), dtype=np.int64)
    for r in range(1, height):
        padded = np.pad(best, 4, constant_values=-1.0)
        choices = np.stack([padded[k : k + width] for k in range(9)])
        back[r] = np.clip(choices.argmax(axis=0) - 4 + np.arange(width), 0, width - 1)
        best = smooth[r] + choices.max(axis=0)
    path = np.empty(height, dtype=np.int64)
    path[-1] = best.argmax()
    for r in range(height - 1, 0, -1):
        path[r - 1] = back[r, path[r]]
    rows = np.arange(height)
    about = np.maximum(*(smooth[rows, np.clip(path + k, 0, width - 1)] for k in (-24, 24)))
    inside = (path > NEAR_PX) & (path < width - NEAR_PX)
    return path.astype(np.float64), inside & (smooth[rows, path] - about > CONTRAST)


def local_variance(line: Line) -> Floats:
    """Variance about a parabola, in px squared, of every ROWS neighbouring points."""
    along, across = line
    terms = np.vander(np.linspace(-1, 1, ROWS), 3)
    rest = np.eye(ROWS) - terms @ np.linalg.pinv(terms)
    if len(along) < ROWS:
        return np.zeros(0)
    windows = np.lib.stride_tricks.sliding_window_view(across, ROWS)
    whole = along[ROWS - 1 :] - along[: 1 - ROWS] == ROWS - 1
    return np.asarray(np.sum((windows[whole] @ rest) ** 2, axis=1) / (ROWS - 3))


def noise_words(variances: list[Floats]) -> str:
    """Median over the windows and rms of all of them."""
    every = np.concatenate(variances)
    return f"{np.sqrt(np.median(every)):.3f} ({np.sqrt(np.mean(every)):.3f})"


def points_near(line: Line, path: Floats) -> Line:
    near = np.abs(line[1] - path[line[0].astype(int)]) <= 2 * NEAR_PX
    return line[0][near], line[1][near]


def print_real(folder: Path) -> None:
    print(f"real, {folder.name}: rows of the line, and its noise in px: median (rms) of windows")
    print("  frame  visible  found  false  core  sigma  noise          ms")
    visible_rows, found_rows, false_rows = 0, 0, 0
    ours: list[Floats] = []
    peers: list[list[Floats]] = [[] for _ in range(2 * len(PEERS))]
    for file in sorted(folder.glob("frame*.png")):
        image = np.asarray(cv2.imread(str(file), cv2.IMREAD_GRAYSCALE), dtype=np.uint8)
        path, visible = line_path(image)
        stripe, spent = time_extraction(image)
        off = np.abs(stripe.u - path[stripe.v.astype(int)])
        found = np.zeros(len(path), dtype=np.bool_)
        found[stripe.v[off <= 2 * NEAR_PX].astype(int)] = True
        false = int(np.sum(off > 2 * NEAR_PX))
        visible_rows += int(visible.sum())
        found_rows += int((found & visible).sum())
        false_rows += false
        turned = np.ascontiguousarray(image.T)
        core = core_width(turned)
        ours.append(local_variance((stripe.v, stripe.u)))
        for k, (_, peer) in enumerate(PEERS):
            line = points_near(peer(turned), path)
            peers[2 * k].append(local_variance(line))
            peers[2 * k + 1].append(local_variance(average_line(line, core)))
        print(
            f"  {file.stem[5:]}   {visible.sum():7d}  {(found & visible).sum():5d}  {false:5d}  "
            f"{core:4d}  {np.median(stripe.sigma_px):.3f}  {noise_words(ours[-1:])}  {spent:5.1f}"
        )
    print(
        f"  all: {found_rows} of {visible_rows} visible rows found "
        f"({100 * found_rows / visible_rows:.2f} %), {false_rows} false points"
    )
    print(f"  noise, crenel: {noise_words(ours)}")
    for k, (name, _) in enumerate(PEERS):
        print(
            f"  noise, {name}: {noise_words(peers[2 * k])}, averaged "
            f"{noise_words(peers[2 * k + 1])}"
        )


def time_extraction(image: Grey) -> tuple[Stripe, float]:
    """The stripe, and the quickest of three runs in milliseconds."""
    spent = []
    stripe = extract_stripe(image, "v")
    for _ in range(3):
        start = time.perf_counter()
        stripe = extract_stripe(image, "v")
        spent.append(1e3 * (time.perf_counter() - start))
    return stripe, min(spent)


if __name__ == "__main__":
    main()
