"""Smoothing of simulated lines against the truth: noise, stated σ, and the line's own shape.

python -m tests.bench smoothing [--json]
"""

from dataclasses import replace

import numpy as np

from crenel.metrology.stripe import Stripe, extract_stripe
from crenel.metrology.stripe.smoothing import smooth_stripe
from crenel.metrology.transforms import Floats
from tests.bench.rows import bench_parser, measured_rows, rms
from tests.bench.stripe.frames import GRAINS, simulate_frame, simulate_overexposure

FRAMES = 16
SMOOTHINGS_PX = (0.0, 1.0, 2.0, 5.0, 10.0)
NEAR_PX = 1.0
SATURATED = 255.0


def simulated_stripes(kind: str) -> list[tuple[Stripe, Floats]]:
    """Extracted points of some frames, and the line's true rows there."""
    found = []
    for seed in range(FRAMES):
        if kind == "saturated patch":
            image, centre, _ = simulate_overexposure(seed)
        else:
            frame = simulate_frame(seed, GRAINS[kind])
            image, centre = frame.image, frame.centre
        stripe = extract_stripe(image)
        truth = centre[stripe.u.astype(np.int64)]
        near = np.abs(stripe.v - truth) < NEAR_PX
        close = Stripe(
            stripe.u[near], stripe.v[near], stripe.intensity[near], stripe.sigma_px[near]
        )
        found.append((close, truth[near]))
    return found


def main() -> None:
    with measured_rows(bench_parser(__doc__).parse_args().json) as rows:
        for kind in (*GRAINS, "saturated patch"):
            stripes = simulated_stripes(kind)
            found = {f"{px:.0f} px": measure(stripes, px) for px in SMOOTHINGS_PX}
            for what in ("noise, px", "claimed / observed", "shape lost, px"):
                rows.add(f"{kind}: {what}", {of: values[what] for of, values in found.items()})


def measure(stripes: list[tuple[Stripe, Floats]], smoothing_px: float) -> dict[str, float]:
    """Rms over all points of the stripes."""
    off, sigma, moved = [], [], []
    for stripe, truth in stripes:
        smoothed = smooth_stripe(stripe, smoothing_px, SATURATED)
        line = smooth_stripe(replace(stripe, v=truth), smoothing_px).v
        off.append(smoothed.v - line)
        sigma.append(smoothed.sigma_px)
        moved.append(line - truth)
    every = np.concatenate(off)
    return {
        "noise, px": rms(every),
        "claimed / observed": 1 / rms(every / np.concatenate(sigma)),
        "shape lost, px": rms(np.concatenate(moved)),
    }


if __name__ == "__main__":
    main()
