"""Extracts the laser stripe from an image, as ``crenel extract`` does.

The simulator renders a flat plate under the laser. Its geometry gives the true place of the line.
"""

import numpy as np

from crenel import StripeSettings, extract_stripe
from crenel_hardware.simulator.devices.kinematics import translation
from crenel_hardware.simulator.scene.camera import to_pixels
from crenel_hardware.simulator.scene.world import Box
from crenel_hardware.simulator.session import SessionPlan, draw_rig, render_scan


def main() -> None:
    plan = SessionPlan(width_px=640, height_px=512)
    rig = draw_rig(seed=3, plan=plan)
    plate = Box((-60.0, -40.0, -12.0), (60.0, 40.0, 0.0))  # its top is the plane z = 0
    pose = rig.T_arm_obj @ translation(0.0, 0.0, 2.0)  # the sensor frame, 2 mm above the plate
    (frame,) = render_scan(rig, plate, rig.T_arm_obj, [pose], plan)
    image = frame.image
    print(f"image: {image.shape[1]} x {image.shape[0]} px, {image.dtype}")

    # Axis "u": at most one point in each column, v measured to a fraction of a pixel.
    stripe = extract_stripe(image, axis="u")
    print(f"points: {len(stripe.u)}")
    for u, v, intensity, sigma_px in list(
        zip(stripe.u, stripe.v, stripe.intensity, stripe.sigma_px, strict=True)
    )[::150]:
        print(f"  u {u:5.0f}  v {v:8.3f}  intensity {intensity:5.1f}  sigma {sigma_px:.3f} px")

    # The true line: where the laser plane meets the plate, projected into the image.
    x = np.linspace(-40.0, 40.0, 2000)
    z = np.full_like(x, -2.0)  # the plate in the sensor frame
    n = rig.light_plane.normal
    y = (rig.light_plane.offset_mm - n[0] * x - n[2] * z) / n[1]
    u, v = to_pixels(rig.optics, np.column_stack([x, y, z])).T
    error_px = stripe.v - np.interp(stripe.u, u, v)
    print(f"standard deviation by the fits: {np.sqrt(np.mean(stripe.sigma_px**2)):.3f} px rms")
    print(f"true error: {np.sqrt(np.mean(error_px**2)):.3f} px rms")

    # A mask and settings restrict the search.
    left = np.zeros(image.shape, dtype=np.bool_)
    left[:, :320] = True
    part = extract_stripe(image, "u", where=left, settings=StripeSettings(min_run=20))
    print(f"points in the left half: {len(part.u)}, all with u < 320: {bool(part.u.max() < 320)}")


if __name__ == "__main__":
    main()
