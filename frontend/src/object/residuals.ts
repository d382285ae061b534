import type { TouchedPoint } from "../api/wire";
import { roundEnd } from "../parts/lengths";

/** Blue for zero through violet to orange for the end of the scale: suitable for colour-blind users. */
const RAMP: [number, number, number][] = [
  [38, 118, 222],
  [140, 92, 205],
  [214, 92, 118],
  [240, 140, 30],
];

export function rampColour(share: number): string {
  const place = Math.min(1, Math.max(0, share)) * (RAMP.length - 1);
  const i = Math.min(RAMP.length - 2, Math.floor(place));
  const low = RAMP[i] ?? [0, 0, 0];
  const high = RAMP[i + 1] ?? low;
  const mix = low.map((value, k) => Math.round(value + ((high[k] ?? value) - value) * (place - i)));
  return `rgb(${mix.join(" ")})`;
}

export const RAMP_CSS = `linear-gradient(90deg, ${[0, 0.25, 0.5, 0.75, 1].map(rampColour).join(", ")})`;

/** The end of the scale in µm: a round number that includes every point except outliers. */
export function scaleEnd(points: TouchedPoint[]): number {
  const sizes = points.filter((p) => !p.outlier).map((p) => Math.abs(p.residual_um ?? 0));
  const largest = Math.max(0, ...sizes);
  return roundEnd(largest, "µm", 10, 1000);
}
