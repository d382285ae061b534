"""Smoothing of simulated lines against the truth: noise, stated σ, and the line's own shape.

python -m tests.bench.smoothing
"""

from dataclasses import replace

import numpy as np

from app.bench.stripe.frames import GRAINS, simulate_frame, simulate_overexposure
from app.metrology.stripe import Stripe, extract_stripe
from app.metrology.stripe.smoothing import smooth_stripe
from app.metrology.transforms import Floats

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
    print(f"{'':<24}" + "".join(f"{smoothing_px:>8.0f} px" for smoothing_px in SMOOTHINGS_PX))
    for kind in (*GRAINS, "saturated patch"):
        stripes = simulated_stripes(kind)
        noise, claimed, bend = [], [], []
        for smoothing_px in SMOOTHINGS_PX:
            off, sigma, moved = [], [], []
            for stripe, truth in stripes:
                smoothed = smooth_stripe(stripe, smoothing_px, SATURATED)
                line = smooth_stripe(replace(stripe, v=truth), smoothing_px).v
                off.append(smoothed.v - line)
                sigma.append(smoothed.sigma_px)
                moved.append(line - truth)
            noise.append(np.sqrt(np.mean(np.concatenate(off) ** 2)))
            pull = np.concatenate(off) / np.concatenate(sigma)
            claimed.append(1 / np.sqrt(np.mean(pull**2)))
            bend.append(np.sqrt(np.mean(np.concatenate(moved) ** 2)))
        for what, values in (
            ("noise, px", noise),
            ("claimed / observed", claimed),
            ("shape lost, px", bend),
        ):
            print(f"{kind + ', ' + what:<44}" + "".join(f"{value:>8.3f}" for value in values))


if __name__ == "__main__":
    main()
